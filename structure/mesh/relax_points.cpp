// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/relax_points.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/exchange/participant.hpp"
#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {
namespace {

constexpr int adapting_rounds = 5;
constexpr int moves_per_round = 2;
constexpr int settling_moves = 4;
constexpr int improving_passes = 12;
constexpr double longest = 1.42;            // edge over target size above which it is split
constexpr double shortest = 0.66;           // edge over target size below which a point of it goes
constexpr double clearance_kept = 0.5;      // of the target size
constexpr double largest_move = 0.3;        // of the target size
constexpr double share_of_clearance = 0.9;  // of the distance to a line that one move may use
constexpr double angle_to_improve = 37;     // [degrees]
constexpr double altitude_weight =
    0.8;  // of an altitude over the smallest target size, against the sine of an angle
constexpr double first_search_step = 0.2;  // of the target size
constexpr int search_halvings = 5;
constexpr int search_directions = 8;
constexpr double beyond_rounding = 1e-9;

class Relaxation {
 public:
  Relaxation(PointCloud& cloud, std::span<const PointPair> edges, const MeshRegion& region)
      : cloud_(cloud), edges_(edges), region_(region) {
    for (const Point& point : cloud_.points) {
      sample_.push_back(region_.sample(point));
      finest_ = std::min(finest_, sample_.back().size);
    }
    for (int k = 0; k < search_directions; ++k) {
      const double angle = 2 * std::numbers::pi * k / search_directions;
      directions_[k] = {std::cos(angle), std::sin(angle)};
    }
  }

  std::vector<PointTriple> run() {
    connect();
    for (int round = 0; round < adapting_rounds; ++round) {
      split_and_remove();
      for (int move = 0; move < moves_per_round; ++move) smooth();
    }
    for (int move = 0; move < settling_moves; ++move) smooth();
    for (int pass = 0; pass < improving_passes && improve_shapes(); ++pass) connect();
    return std::move(triangles_);
  }

 private:
  void connect() {
    note_progress("mesh");
    triangles_ = triangulate(cloud_.points, edges_);
    first_.assign(cloud_.points.size() + 1, 0);
    for (const PointTriple& t : triangles_)
      for (const std::uint32_t p : t) ++first_[p + 1];
    for (std::size_t p = 0; p < cloud_.points.size(); ++p) first_[p + 1] += first_[p];
    incident_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (const std::uint32_t p : triangles_[t]) incident_[next[p]++] = t;
  }

  [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t point) const {
    return {incident_.data() + first_[point], first_[point + 1] - first_[point]};
  }

  // A point may come nearer to a line than the clearance kept only if that takes it farther away than it was.
  [[nodiscard]] bool may_move(std::uint32_t point, const MeshRegion::Sample& to, double step) const {
    const MeshRegion::Sample& from = sample_[point];
    return step <= largest_move * from.size && step <= share_of_clearance * from.clearance &&
           (to.clearance >= clearance_kept * to.size || to.clearance >= from.clearance);
  }

  void split_and_remove() {
    enum : char { untouched, kept, removed };
    std::vector<char> mark(cloud_.points.size(), untouched);
    std::vector<Point> added;
    for (const PointTriple& t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (a > b || mark[a] != untouched || mark[b] != untouched) continue;
        const Point p = cloud_.points[a], q = cloud_.points[b];
        const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
        const double size = (sample_[a].size + sample_[b].size) / 2;
        if (length > longest * size) {
          const Point middle{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
          if (region_.sample(middle).clearance < clearance_kept * size) continue;
          added.push_back(middle);
          mark[a] = mark[b] = kept;
        } else if (length < shortest * size && !cloud_.held[b]) {
          mark[a] = kept;
          for (const std::uint32_t neighbour : around(b))
            for (const std::uint32_t v : triangles_[neighbour])
              if (mark[v] == untouched) mark[v] = kept;
          mark[b] = removed;
        }
      }
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < cloud_.points.size(); ++i) {
      if (mark[i] == removed) continue;
      cloud_.points[count] = cloud_.points[i];
      cloud_.held[count] = cloud_.held[i];
      sample_[count++] = sample_[i];
    }
    cloud_.points.resize(count);
    cloud_.held.resize(count);
    sample_.resize(count);
    for (const Point& point : added) {
      cloud_.points.push_back(point);
      cloud_.held.push_back(0);
      sample_.push_back(region_.sample(point));
    }
    connect();
  }

  [[nodiscard]] Point mean_of_circumcentres(std::uint32_t point) const {
    double weight = 0, x = 0, y = 0;
    const Point origin = cloud_.points[point];
    for (const std::uint32_t t : around(point)) {
      const auto [a, b, c] = triangles_[t];
      const Point centre = circumcentre(cloud_.points[a], cloud_.points[b], cloud_.points[c]);
      const double size = (sample_[a].size + sample_[b].size + sample_[c].size) / 3;
      const double share =
          twice_area(cloud_.points[a], cloud_.points[b], cloud_.points[c]) / (size * size * size * size);
      weight += share;
      x += share * (centre[0] - origin[0]);
      y += share * (centre[1] - origin[1]);
    }
    return {origin[0] + x / weight, origin[1] + y / weight};
  }

  void smooth() {
    std::vector<Point> moved = cloud_.points;
    for (std::uint32_t i = cloud_.prescribed; i < cloud_.points.size(); ++i) {
      if (cloud_.held[i]) continue;
      const Point from = cloud_.points[i], wanted = mean_of_circumcentres(i);
      const double step = std::hypot(wanted[0] - from[0], wanted[1] - from[1]);
      const double allowed =
          std::min(largest_move * sample_[i].size, share_of_clearance * sample_[i].clearance);
      const double share = step > allowed ? allowed / step : 1.0;
      const Point to{from[0] + share * (wanted[0] - from[0]), from[1] + share * (wanted[1] - from[1])};
      const MeshRegion::Sample sample = region_.sample(to);
      if (!may_move(i, sample, share * step * (1 - 1e-9))) continue;
      moved[i] = to;
      sample_[i] = sample;
    }
    cloud_.points = std::move(moved);
    connect();
  }

  [[nodiscard]] std::array<Point, 3> corners(std::uint32_t triangle, std::uint32_t point, Point place) const {
    std::array<Point, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = triangles_[triangle][k] == point ? place : cloud_.points[triangles_[triangle][k]];
    return corner;
  }

  // The smallest angle around a point that stands at `place`, or less where an altitude is small for the
  // target size.
  [[nodiscard]] double worst_shape_around(std::uint32_t point, Point place) const {
    double worst = std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : around(point)) {
      const auto [a, b, c] = corners(t, point, place);
      const TriangleShape triangle = shape(a, b, c);
      worst = std::min(
          {worst, triangle.sine_of_smallest_angle, altitude_weight * triangle.smallest_altitude / finest_});
    }
    return worst;
  }

  // About the square of worst_shape_around, without a root; looks no further than the first below `enough`.
  [[nodiscard]] double squared_worst_shape_around(std::uint32_t point, Point place, double enough) const {
    const double altitude_scale = altitude_weight * altitude_weight / (finest_ * finest_);
    double worst = std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : around(point)) {
      const auto [a, b, c] = corners(t, point, place);
      const SquaredShape squared = squared_shape(a, b, c);
      worst = std::min({worst, squared.sine_of_smallest_angle, altitude_scale * squared.smallest_altitude});
      if (worst < enough) break;
    }
    return worst;
  }

  [[nodiscard]] bool surely_above(double bound, std::uint32_t point, Point place) const {
    const double limit = bound * bound * (1 + beyond_rounding);
    return squared_worst_shape_around(point, place, limit) > limit;
  }

  [[nodiscard]] bool surely_below(double bound, std::uint32_t point, Point place) const {
    const double limit = bound * bound * (1 - beyond_rounding);
    return bound > 0 && squared_worst_shape_around(point, place, limit) < limit;
  }

  // Tells whether the triangles around a point are those of an earlier search.
  [[nodiscard]] std::uint64_t surroundings(std::uint32_t point) const {
    std::uint64_t sum = 0;
    for (const std::uint32_t t : around(point)) {
      std::uint64_t mixed = 0;
      for (const std::uint32_t corner : triangles_[t])
        for (const double coordinate : cloud_.points[corner]) {
          mixed = (std::rotl(mixed, 29) ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15u;
          mixed ^= mixed >> 32;
        }
      sum += mixed;
    }
    return sum;
  }

  // Whether the point has moved to a better place.
  bool improve_shapes_around(std::uint32_t i, double enough) {
    if (surely_above(enough, i, cloud_.points[i])) return false;
    double best = worst_shape_around(i, cloud_.points[i]);
    if (best >= enough) return false;
    const std::uint64_t here = surroundings(i);
    if (in_vain_[i] == here) return false;
    bool moved = false;
    double step = first_search_step * sample_[i].size;
    for (int halving = 0; halving < search_halvings && best < enough; ++halving, step /= 2)
      for (const Point& direction : directions_) {
        const Point from = cloud_.points[i];
        const Point to{from[0] + step * direction[0], from[1] + step * direction[1]};
        if (surely_below(best, i, to)) continue;
        const double shape_there = worst_shape_around(i, to);
        if (shape_there <= best) continue;
        const MeshRegion::Sample sample = region_.sample(to);
        if (!may_move(i, sample, step)) continue;
        best = shape_there;
        cloud_.points[i] = to;
        sample_[i] = sample;
        moved = true;
      }
    if (!moved) in_vain_[i] = here;
    return moved;
  }

  // Whether any point has moved.
  bool improve_shapes() {
    bool moved = false;
    const double enough = std::sin(angle_to_improve * std::numbers::pi / 180);
    in_vain_.resize(cloud_.points.size(), 0);
    for (std::uint32_t i = cloud_.prescribed; i < cloud_.points.size(); ++i)
      if (!cloud_.held[i] && improve_shapes_around(i, enough)) moved = true;
    return moved;
  }

  PointCloud& cloud_;
  std::span<const PointPair> edges_;
  const MeshRegion& region_;
  std::vector<MeshRegion::Sample> sample_;
  double finest_ = std::numeric_limits<double>::infinity();  // smallest target size [m]
  std::vector<PointTriple> triangles_;
  std::vector<std::uint32_t> first_, incident_;  // triangles around each point
  std::array<Point, search_directions> directions_;
  std::vector<std::uint64_t> in_vain_;  // of each point: surroundings in which no place was better
};

}  // namespace

std::vector<PointTriple> relax_points(PointCloud& cloud, std::span<const PointPair> edges,
                                      const MeshRegion& region) {
  return Relaxation(cloud, edges, region).run();
}

}  // namespace fissura::structure
