// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/case/case.hpp"
#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "common/seismicity/source_record.hpp"
#include "coupler/record/interval_record.hpp"
#include "coupler/record/meetings.hpp"
#include "coupler/record/probes.hpp"
#include "coupler/record/remesh_ledger.hpp"

/// From messages to values, with every check that physics allows. Arrays have one value per node of the
/// network.
namespace fissura::coupler {

/// RESPONSE, or the same arrays of TOPOLOGY and ACKNOWLEDGE.
struct StructureResponse {
  std::vector<double> aperture;          ///< [m]
  std::vector<double> aperture_rate;     ///< [m/s]
  std::vector<double> pressure_applied;  ///< [Pa]
  std::vector<double> pressure_opening;  ///< [Pa]
  std::vector<double> closed, broken;    ///< 0 or 1
  /// Of each segment's own arm at its two ends [m]; empty from a structure that does not tell.
  std::vector<double> arm_aperture_a, arm_aperture_b;
  double stable_step = 0;  ///< [s]
  double mass_scale = 1;
  int steps = 0;                               ///< RESPONSE only, like the rest
  double kinetic_energy = 0;                   ///< [J]
  std::optional<double> strain_energy;         ///< [J], if it was asked for
  double cohesive_work = 0, failure_work = 0;  ///< so far [J]; 0 from a structure that does not tell
  std::uint64_t elements = 0;                  ///< of the mesh; the same
  NaturalFractureFigures natural_fractures;    ///< the same
  std::vector<ProbeValues> probes;    ///< in the order of the case; empty from a structure that does not tell
  std::vector<SourceRecord> sources;  ///< in any order; empty from a structure that does not tell
  std::uint64_t sources_merged = 0;   ///< records that went into others of this interval
  PlaneTensor transfer_moment{};  ///< that insertions changed so far while they carried the state over [N m]
  std::optional<Insertion> proposal;
};

/// PRESSURE.
struct NetworkAnswer {
  std::vector<double> pressure;            ///< [Pa]
  std::vector<double> aperture_predicted;  ///< [m]
  std::vector<double> filled;              ///< [0, 1]
  Ledger ledger;
  double well_pressure = 0;  ///< [Pa]
  double rate = 0;           ///< [m3/s]
  int newton_iterations = 0;
  int halvings = 0;
};

/// Throws ProtocolError for missing or misshaped data, ValueError naming field, node, coordinates and value
/// for what physics forbids: a negative aperture, a pressure outside the range of the case, a filled fraction
/// outside [0, 1].
StructureResponse read_response(const Message& message, const FractureNetwork& network,
                                const PressureRange& range);
/// What the insertion did to the mesh; empty from a structure that does not tell. Throws ProtocolError.
std::vector<Remeshing> read_remeshing(const Message& acknowledgement);
/// The meetings of the insertion, each with its decision; empty without any. Throws ProtocolError.
std::vector<Meeting> read_meetings(const Message& acknowledgement);
NetworkAnswer read_pressure(const Message& message, const FractureNetwork& network,
                            const PressureRange& range);

/// |residual| over the largest volume in the book.
double relative_residual(const Ledger& ledger);

}  // namespace fissura::coupler
