// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/analysis/stimulated_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace fissura::coupler {

namespace {

double turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// One side of the hull, without its last corner.
template <class Iterator>
void add_side(Iterator begin, Iterator end, std::vector<Point>& corners) {
  const std::size_t first = corners.size();
  for (auto point = begin; point != end; ++point) {
    while (corners.size() >= first + 2 && turn(corners[corners.size() - 2], corners.back(), *point) <= 0)
      corners.pop_back();
    corners.push_back(*point);
  }
  corners.pop_back();
}

}  // namespace

std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  std::vector<Point> corners;
  add_side(points.begin(), points.end(), corners);
  add_side(points.rbegin(), points.rend(), corners);
  return corners;
}

double polygon_area(const std::vector<Point>& corners) {
  double area = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) area += turn(corners[0], corners[i - 1], corners[i]) / 2;
  return area;
}

StimulatedVolume stimulated_volume(const std::vector<SeismicEvent>& events, const Seismicity& controls,
                                   double thickness) {
  StimulatedVolume volume;
  const double size = volume.cell_size = controls.voxel_size;
  volume.cell_events = controls.voxel_events;
  volume.thickness = thickness;
  std::map<std::array<double, 2>, std::size_t> events_in;
  std::vector<Point> places;
  for (const SeismicEvent& event : events) {
    places.push_back(event.centroid);
    ++events_in[{std::floor(event.centroid[0] / size), std::floor(event.centroid[1] / size)}];
  }
  for (const auto& [cell, count] : events_in)
    if (count >= static_cast<std::size_t>(volume.cell_events))
      volume.cells.push_back({{(cell[0] + 0.5) * size, (cell[1] + 0.5) * size}, count});
  volume.cell_volume = static_cast<double>(volume.cells.size()) * size * size * thickness;
  volume.hull = convex_hull(std::move(places));
  volume.hull_volume = polygon_area(volume.hull) * thickness;
  return volume;
}

}  // namespace fissura::coupler
