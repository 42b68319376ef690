// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// One coupling step as a relay: coupler -> network -> coupler -> structure -> coupler, without the work of
/// the solvers.
namespace fissura::bench {

/// float64 arrays that each message carries (docs/protocol.md).
inline constexpr std::size_t advance_arrays = 5, pressure_arrays = 3, response_arrays = 6;
inline constexpr std::size_t arrays_per_step = 2 * advance_arrays + pressure_arrays + response_arrays;

/// The coupler's end of three processes that hand arrays to each other.
class Relay {
 public:
  virtual ~Relay() = default;

  /// Number of values in every array from now on.
  virtual void set_values(std::size_t count) = 0;
  /// One coupling step; returns when the structure's answer is there.
  virtual void step() = 0;
};

}  // namespace fissura::bench
