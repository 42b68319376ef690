// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/interior_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "structure/mesh/lattice.hpp"

namespace fissura::structure {
namespace {

constexpr double row_height = std::numbers::sqrt3 / 2;  // in units of the spacing along the row
constexpr double nearest_in_rows = 0.75;                // of the spacing
constexpr double nearest_in_front = 0.8;                // of the target size
constexpr double row_clearance = 0.5;                   // of the spacing, from lines and sides
constexpr double front_clearance = 0.6;                 // of the target size
constexpr double same_place = 1e-6;                     // of the spacing
constexpr double direction_jitter = 0.2;                // [rad]
constexpr double distance_jitter = 0.08;                // of the target size
constexpr double steepest_growth = 0.75;                // bound on the change of size within a search radius
constexpr double half_sector = std::numbers::pi / 6;    // turns a hexagon by up to this cover all directions
constexpr double uniform_within = 1e-9;                 // relative

class Placement {
 public:
  Placement(const LineArrangement& lines, const PrescribedPoints& prescribed, const MeshRegion& region,
            const Case& given)
      : stretches_(stretches(lines, given)),
        region_(region),
        given_(given),
        controls_(given.mesh),
        random_(given.mesh.seed) {
    cloud_.prescribed = static_cast<std::uint32_t>(prescribed.points.size());
    cloud_.held.assign(prescribed.points.size(), 1);
    cloud_.points = prescribed.points;
    heading_.assign(prescribed.points.size(), 0.0);
    for (const PointPair& edge : prescribed.edges) {
      const Point a = prescribed.points[edge[0]], b = prescribed.points[edge[1]];
      heading_[edge[0]] = heading_[edge[1]] = std::atan2(b[1] - a[1], b[0] - a[0]);
    }
    for (const Point& point : cloud_.points) {
      spacing_.push_back(region_.field().size(point));
      taken_.add(point, spacing_.back());
    }
  }

  PointCloud place() {
    if (controls_.lattice_angle)
      add_lattices();
    else if (given_.growth.path == PathRule::prescribed)
      add_rows();
    hold_full_rings();
    spread();
    return std::move(cloud_);
  }

 private:
  void add(Point point, double size, double heading) {
    cloud_.points.push_back(point);
    cloud_.held.push_back(0);
    heading_.push_back(heading);
    spacing_.push_back(size);
    taken_.add(point, size);
  }

  void add_lattices() {
    for (const UniformPart& part : uniform_parts(given_, stretches_))
      for (const Point& point : hexagonal_lattice(part, *controls_.lattice_angle)) {
        const MeshRegion::Sample sample = region_.sample(point);
        if (std::abs(sample.size - part.size) <= uniform_within * part.size &&
            has_room(point, sample, part.size))
          add(point, part.size, *controls_.lattice_angle);
      }
  }

  [[nodiscard]] bool has_room(Point point, const MeshRegion::Sample& sample, double spacing) const {
    return sample.clearance >= row_clearance * spacing &&
           taken_.nearest(point, nearest_in_rows * spacing, (1 - steepest_growth) * spacing) >=
               nearest_in_rows * spacing;
  }

  void add_rows() {
    int rows = 0;
    for (const SizedSegment& s : stretches_)
      rows = std::max(rows, static_cast<int>(std::floor(controls_.corridor / (row_height * s.edge_length))));
    for (int row = 0; row <= rows; ++row)
      for (const SizedSegment& stretch : stretches_) {
        add_row(stretch, row);
        if (row > 0) add_row(stretch, -row);
      }
  }

  void add_row(const SizedSegment& stretch, int row) {
    const double spacing = stretch.edge_length, offset = row * row_height * spacing;
    if (std::abs(offset) > controls_.corridor) return;
    const double length = std::hypot(stretch.end[0] - stretch.begin[0], stretch.end[1] - stretch.begin[1]);
    const double tx = (stretch.end[0] - stretch.begin[0]) / length,
                 ty = (stretch.end[1] - stretch.begin[1]) / length;
    const int count = static_cast<int>(std::lround(length / spacing));
    const int beyond = static_cast<int>(std::ceil(controls_.corridor / spacing));
    const double stagger = row % 2 == 0 ? 0.0 : 0.5;
    for (int i = -beyond; i <= count + beyond; ++i) {
      if (row == 0 && i >= 0 && i <= count) continue;
      const double along = (i + stagger) * spacing;
      const Point point{stretch.begin[0] + along * tx - offset * ty,
                        stretch.begin[1] + along * ty + offset * tx};
      if (belongs_to(stretch, point)) add(point, spacing, std::atan2(ty, tx));
    }
  }

  bool belongs_to(const SizedSegment& stretch, Point point) const {
    const double spacing = stretch.edge_length;
    const double own = distance_to_segment(point, stretch.begin, stretch.end);
    if (own > controls_.corridor) return false;
    const MeshRegion::Sample sample = region_.sample(point);
    return sample.distance >= own - same_place * spacing &&
           sample.size >= (1 - distance_jitter) * std::min(spacing, stretch.size) &&
           has_room(point, sample, spacing);
  }

  void hold_full_rings() {
    for (std::uint32_t i = cloud_.prescribed; i < cloud_.points.size(); ++i) {
      const Point point = cloud_.points[i];
      const double spacing = spacing_[i];
      bool full = true;
      for (int k = 0; k < 6 && full; ++k) {
        const double angle = heading_[i] + k * std::numbers::pi / 3;
        const Point neighbour{point[0] + spacing * std::cos(angle), point[1] + spacing * std::sin(angle)};
        full = taken_.nearest(neighbour, spacing / 2, (1 - steepest_growth) * spacing) < same_place * spacing;
      }
      cloud_.held[i] = full ? 1 : 0;
    }
  }

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

  void spread() {
    for (std::uint32_t i = 0; i < cloud_.points.size(); ++i) {
      if (cloud_.held[i] && i >= cloud_.prescribed) continue;
      const Point from = cloud_.points[i];
      const double size = region_.field().size(from);
      const double turn = given_.growth.path == PathRule::free ? uniform(-half_sector, half_sector) : 0;
      for (int k = 0; k < 6; ++k) {
        const double angle =
            heading_[i] + turn + k * std::numbers::pi / 3 + uniform(-direction_jitter, direction_jitter);
        const double stretch = uniform(1 - distance_jitter, 1 + distance_jitter);
        const Point guess{from[0] + size * std::cos(angle), from[1] + size * std::sin(angle)};
        const double step = stretch * (size + region_.field().size(guess)) / 2;
        const Point point{from[0] + step * std::cos(angle), from[1] + step * std::sin(angle)};
        const MeshRegion::Sample sample = region_.sample(point);
        if (sample.clearance < front_clearance * sample.size) continue;
        const double radius = nearest_in_front * sample.size;
        if (taken_.nearest(point, radius, (1 - steepest_growth) * sample.size) < radius) continue;
        add(point, sample.size, angle);
      }
    }
  }

  std::vector<SizedSegment> stretches_;
  const MeshRegion& region_;
  const Case& given_;
  const MeshControls& controls_;
  std::mt19937_64 random_;
  PointCloud cloud_;
  std::vector<double> heading_;  // direction in which the neighbours of a point are sought first [rad]
  std::vector<double> spacing_;  // distance of the neighbours of a point [m]
  OccupancyGrid taken_;
};

}  // namespace

PointCloud place_interior_points(const LineArrangement& lines, const PrescribedPoints& prescribed,
                                 const MeshRegion& region, const Case& given) {
  return Placement(lines, prescribed, region, given).place();
}

}  // namespace fissura::structure
