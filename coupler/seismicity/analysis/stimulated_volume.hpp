// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "common/case/case.hpp"
#include "coupler/seismicity/seismic_event.hpp"

namespace fissura::coupler {

/// A cell of the plane with events in it.
struct StimulatedCell {
  Point middle{};  ///< [m]
  std::size_t events = 0;
};

/// Two measures of how much rock the events fill. The hull overstates clouds that are not convex; the cells
/// depend on their size and on how many events the mesh makes.
struct StimulatedVolume {
  double cell_size = 0;               ///< a [m]
  int cell_events = 0;                ///< fewest events of a cell that counts
  std::vector<StimulatedCell> cells;  ///< those that count, by x, then y
  double cell_volume = 0;             ///< their number times a^2 H [m3]
  std::vector<Point> hull;            ///< corners, counter-clockwise; the ends only of events on a line
  double hull_volume = 0;             ///< its area times H [m3]
  double thickness = 0;               ///< H, of the layer [m]
};

/// From the centroids of the events, with the cells of `controls`; the origin is a corner of a cell.
StimulatedVolume stimulated_volume(const std::vector<SeismicEvent>& events, const Seismicity& controls,
                                   double thickness);

/// Corners of the convex hull, counter-clockwise from the lowest of the leftmost, none between two others on
/// a line (monotone chain, Andrew 1979).
std::vector<Point> convex_hull(std::vector<Point> points);

/// Area of a polygon with corners counter-clockwise [m2].
double polygon_area(const std::vector<Point>& corners);

}  // namespace fissura::coupler
