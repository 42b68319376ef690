// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "common/natural_fractures/draw_traces.hpp"
#include "common/natural_fractures/scatter.hpp"

namespace fissura {

/// What draws of a quantity have on average, and what the draws at hand have. Lengths in m, angles in rad.
struct QuantityStatistics {
  Moments expected, obtained;
  std::size_t count = 0;  ///< draws behind `obtained`
};

/// A set as drawn against its input. Measured on the traces whose centre lies in the region of the set,
/// before they were cut at its edge; P21 on all, after they were.
struct SetStatistics {
  std::string set;
  QuantityStatistics orientation;  ///< of the axes: the mean lies within a right angle of the input (Mardia
                                   ///< and Jupp 2000, sec. 2.3, 9.4)
  QuantityStatistics spacing, length, persistence;
  double expected_density = 0, density = 0;      ///< P20 [1/m2]
  double expected_intensity = 0, intensity = 0;  ///< P21 [1/m]
  std::size_t traces = 0;                        ///< drawn, however short
  std::size_t cleaned_traces = 0;                ///< left after cleaning
  double cleaned_intensity = 0;                  ///< P21 after cleaning [1/m]
};

/// @pre `traces` are those of draw_traces(set). The numbers after cleaning are left 0.
SetStatistics statistics(const NaturalFractureSet& set, std::span<const DrawnTrace> traces);

}  // namespace fissura
