// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/case/case.hpp"
#include "common/coupling/coupling_clock.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "coupler/scheme/exchange.hpp"
#include "coupler/scheme/interval_control.hpp"

namespace fissura::coupler {

/// What the scheme carries from one coupling interval to the next: all of it, so that a run can go on from it
/// bit for bit.
struct SchemeState {
  /// Before the first interval of a run that ends at `end` [s].
  SchemeState(const Case& run_case, double end);

  CouplingClock clock;
  IntervalControl interval_control;
  std::vector<Insertion> insertions;  ///< that made the network, from revision 0
  FractureNetwork network;
  StructureResponse structure;           ///< at the last coupling time
  std::vector<double> network_pressure;  ///< of the last interval [Pa]; profit2016 carries it
  std::vector<double> average_rate;      ///< of the aperture in the last interval [m/s]; profit2016
  double strain_energy = 0;              ///< at the last report [J]
  std::uint64_t reports = 0;
};

/// At a coupling time, with no insertion proposed.
std::vector<std::byte> save(const SchemeState& state);

/// Gives `state`, one of the same case and end, what was saved. Throws Error(checkpoint_unusable) if the
/// bytes are no saved scheme.
void restore(const std::vector<std::byte>& bytes, SchemeState& state);

/// What is wrong with how a restored structure describes itself: the name of the first array that is not, bit
/// for bit, that of the saved state; empty if all are.
std::string difference(const StructureResponse& saved, const StructureResponse& restored);

}  // namespace fissura::coupler
