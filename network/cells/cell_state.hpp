// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/flow_solver/pumping_schedule.hpp"
#include "network/cells/sweep.hpp"

namespace fissura::cells {

/// A sum that keeps what rounding takes away (Neumaier 1974).
struct LongSum {
  double sum = 0, correction = 0;

  void add(double term);
  [[nodiscard]] double value() const { return sum + correction; }
};

/// Everything that later answers depend on. Per node, in the order of the network.
struct CellState {
  double time = 0;  ///< [s]
  bool started = false;
  std::vector<double> content;   ///< m [m]
  std::vector<double> pressure;  ///< [Pa]
  std::vector<double> filled;    ///< [-]
  std::vector<double> leaked;    ///< [m]
  std::vector<Sweep> sweep;
  std::vector<double> contact_pressure;  ///< handed on, not used [Pa]
  std::vector<double> aperture;          ///< measured, of the last interval [m]
  std::vector<std::uint64_t> segment;    ///< ids, in the order of `flux`
  std::vector<double> flux;              ///< from a to b, mean of the last piece [m2/s]
  double well_pressure = 0;              ///< [Pa]
  double rate = 0;                       ///< [m2/s]
  std::optional<std::uint64_t> stage;    ///< in force
  StageEntry stage_entry;
  std::vector<unsigned char> joining;      ///< handed on, not used
  double in_place = 0, found = 0;          ///< whole thickness [m3]
  LongSum injected, leaked_in_all, reset;  ///< whole thickness [m3]
};

std::vector<std::byte> bytes_of(const CellState& state);

/// Throws Error(checkpoint_unusable) if they are not of so many nodes, segments and pumping stages.
CellState state_from(std::span<const std::byte> bytes, std::size_t nodes, std::size_t segments,
                     std::size_t stages);

}  // namespace fissura::cells
