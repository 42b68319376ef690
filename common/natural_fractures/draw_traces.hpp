// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "common/case/case.hpp"

namespace fissura {

/// A trace as drawn.
struct DrawnTrace {
  std::size_t row =
      0;           ///< rows are numbered across strike, traces within a row follow one another along strike
  Point centre{};  ///< [m]
  double azimuth = 0;    ///< of the trace itself, from north (y), clockwise [rad]
  double length = 0;     ///< before it was cut at the edge of the region [m]
  Point begin{}, end{};  ///< of the part within the region, on a grid of 2^-20 m [m]
};

/// Draws the traces of a set: rows along the mean strike, `spacing` apart, and on each row traces of `length`
/// repeated by `persistence`, each turned about its centre to an azimuth of its own. Where rows and traces
/// begin is random such that the process is stationary (the interval that holds the first point is drawn in
/// proportion to its length, Cox 1962, "Renewal Theory", sec. 5.4), and a trace that crosses the edge of the
/// region is cut there: the length of traces per area is then unbiased up to the edge. Traces of one row may
/// overlap where the reading is repeat and length scatters beyond persistence. The same set gives the same
/// traces on every machine.
std::vector<DrawnTrace> draw_traces(const NaturalFractureSet& set);

/// Mean distance along strike from the begin of one trace to the begin of the next [m].
double mean_repeat(const NaturalFractureSet& set);

/// Number of traces per area of a set on average, 1 / (spacing repeat) [1/m2] (P20 of Dershowitz and Herda
/// 1992).
double expected_density(const NaturalFractureSet& set);

/// Length of traces per area of a set on average, length / (spacing repeat) [1/m] (P21).
double expected_intensity(const NaturalFractureSet& set);

/// Unit vectors along a strike of azimuth `azimuth` [rad] and to its right.
struct StrikeAxes {
  Point along{}, across{};
};
StrikeAxes strike_axes(double azimuth);

}  // namespace fissura
