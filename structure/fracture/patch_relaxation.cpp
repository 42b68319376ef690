// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/patch_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

#include "structure/fracture/patch_mesh.hpp"
#include "structure/mesh/triangle_shape.hpp"

namespace fissura::structure {

namespace {

constexpr int adapting_rounds = 6;
constexpr int moves_per_round = 2;
constexpr int settling_moves = 4;
constexpr int improving_passes = 6;
constexpr int search_directions = 8, search_halvings = 4;
constexpr double widest = 0.78;              // circumradius over target size above which a point is added
constexpr double nearest_point = 0.62;       // of a point that is added, over target size
constexpr double nearest_edge = 0.45;        // of the same to an edge that is kept
constexpr double crowded = 0.55;             // distance over target size below which a free point goes
constexpr double first_search_step = 0.2;    // of the target size
constexpr double good_quality = 0.62;
constexpr double altitude_weight = 0.8;      // of an altitude over the target size, against the sine of an angle

std::uint64_t key(std::uint32_t begin, std::uint32_t end) { return (std::uint64_t{begin} << 32) | end; }

/// The triangles on the patch's side of the outline: those that have a side, and all that can be reached from them without crossing one.
std::vector<PointTriple> inside(const std::vector<PointTriple>& triangles, const std::vector<PointPair>& sides) {
  std::unordered_map<std::uint64_t, std::uint32_t> left_of;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) left_of.emplace(key(triangles[t][k], triangles[t][(k + 1) % 3]), t);
  std::vector<char> found(triangles.size(), 0);
  std::vector<std::uint32_t> front;
  std::unordered_set<std::uint64_t> walls;
  const auto reach = [&](std::uint64_t edge) {
    const auto triangle = left_of.find(edge);
    if (triangle == left_of.end() || found[triangle->second]) return;
    found[triangle->second] = 1;
    front.push_back(triangle->second);
  };
  for (const PointPair& side : sides) {
    walls.insert({key(side[0], side[1]), key(side[1], side[0])});
    reach(key(side[0], side[1]));
  }
  while (!front.empty()) {
    const PointTriple t = triangles[front.back()];
    front.pop_back();
    for (int k = 0; k < 3; ++k)
      if (!walls.contains(key(t[k], t[(k + 1) % 3]))) reach(key(t[(k + 1) % 3], t[k]));
  }
  std::vector<PointTriple> kept;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (found[t]) kept.push_back(triangles[t]);
  return kept;
}

class PatchRelaxation {
 public:
  explicit PatchRelaxation(PatchProblem& problem) : problem_(problem) {}

  std::vector<PointTriple> run() {
    connect();
    for (int round = 0; round < adapting_rounds; ++round) {
      const bool removed = remove_crowded(), added = add_points();
      if (!removed && !added && round > 0) break;
      for (int move = 0; move < moves_per_round; ++move) smooth();
    }
    for (int move = 0; move < settling_moves; ++move) smooth();
    for (int pass = 0; pass < improving_passes && improve(); ++pass) connect();
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] const Point& at(std::uint32_t point) const { return problem_.points[point]; }
  [[nodiscard]] double size(const PointTriple& t) const { return (size_[t[0]] + size_[t[1]] + size_[t[2]]) / 3; }

  void connect() {
    triangles_ = inside(triangulate(problem_.points, problem_.edges), problem_.sides);
    for (std::size_t p = 0; p < problem_.points.size(); ++p)
      if (p >= size_.size())
        size_.push_back(problem_.field->size(problem_.points[p]));
      else if (p >= problem_.fixed && moved_[p])
        size_[p] = problem_.field->size(problem_.points[p]);
    moved_.assign(problem_.points.size(), 0);
    incident_.assign(problem_.points.size(), {});
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (const std::uint32_t p : triangles_[t]) incident_[p].push_back(t);
  }

  [[nodiscard]] bool in_patch(const Point& point) const {
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const PointTriple& t) {
      return holds({at(t[0]), at(t[1]), at(t[2])}, point);
    });
  }

  bool remove_crowded() {
    std::vector<char> goes(problem_.points.size(), 0);
    for (const PointTriple& t : triangles_)
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = std::min(t[k], t[(k + 1) % 3]), b = std::max(t[k], t[(k + 1) % 3]);
        if (b < problem_.fixed || goes[a] || goes[b]) continue;
        if (std::hypot(at(a)[0] - at(b)[0], at(a)[1] - at(b)[1]) < crowded * size_[b]) goes[b] = 1;
      }
    std::size_t kept = problem_.fixed;
    for (std::size_t p = problem_.fixed; p < problem_.points.size(); ++p) {
      if (goes[p]) continue;
      problem_.points[kept] = problem_.points[p];
      problem_.origin[kept - problem_.fixed] = problem_.origin[p - problem_.fixed];
      size_[kept] = size_[p];
      ++kept;
    }
    if (kept == problem_.points.size()) return false;
    problem_.points.resize(kept);
    problem_.origin.resize(kept - problem_.fixed);
    size_.resize(kept);
    moved_.assign(kept, 0);
    connect();
    return true;
  }

  bool add_points() {
    struct Wide {
      double ratio = 0;
      std::uint32_t triangle = 0;
    };
    std::vector<Wide> wide;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      const Point centre = circumcentre(at(a), at(b), at(c));
      const double radius = std::hypot(centre[0] - at(a)[0], centre[1] - at(a)[1]);
      if (const double ratio = radius / size(triangles_[t]); ratio > widest) wide.push_back({ratio, t});
    }
    std::sort(wide.begin(), wide.end(), [](const Wide& p, const Wide& q) {
      return p.ratio != q.ratio ? p.ratio > q.ratio : p.triangle < q.triangle;
    });
    const std::size_t before = problem_.points.size();
    for (const Wide& candidate : wide) {
      const auto& [a, b, c] = triangles_[candidate.triangle];
      const Point middle{(at(a)[0] + at(b)[0] + at(c)[0]) / 3, (at(a)[1] + at(b)[1] + at(c)[1]) / 3};
      for (const Point& point : {circumcentre(at(a), at(b), at(c)), middle})
        if (may_add(point)) {
          problem_.points.push_back(point);
          problem_.origin.push_back(PatchMesh::added);
          break;
        }
    }
    if (problem_.points.size() == before) return false;
    connect();
    return true;
  }

  [[nodiscard]] bool may_add(const Point& point) const {
    const double h = problem_.field->size(point);
    for (const Point& other : problem_.points)
      if (std::hypot(point[0] - other[0], point[1] - other[1]) < nearest_point * h) return false;
    for (const PointPair& edge : problem_.edges)
      if (distance_to_segment(point, at(edge[0]), at(edge[1])) < nearest_edge * h) return false;
    return in_patch(point);
  }

  void smooth() {
    std::vector<Point> moved = problem_.points;
    for (std::uint32_t p = static_cast<std::uint32_t>(problem_.fixed); p < problem_.points.size(); ++p) {
      double x = 0, y = 0, weights = 0;
      for (const std::uint32_t t : incident_[p]) {
        const auto& [a, b, c] = triangles_[t];
        const Point middle{(at(a)[0] + at(b)[0] + at(c)[0]) / 3, (at(a)[1] + at(b)[1] + at(c)[1]) / 3};
        const double h = size(triangles_[t]), weight = twice_area(at(a), at(b), at(c)) / (h * h * h * h);
        x += weight * middle[0];
        y += weight * middle[1];
        weights += weight;
      }
      if (weights == 0) continue;
      const Point target{x / weights, y / weights};
      if (quality(p, target) <= 0) continue;
      moved[p] = target;
      moved_[p] = 1;
    }
    problem_.points = std::move(moved);
    connect();
  }

  /// Least quality of the triangles around a free point if it stood at `place`.
  [[nodiscard]] double quality(std::uint32_t point, const Point& place) const {
    double least = 1;
    for (const std::uint32_t t : incident_[point]) {
      std::array<Point, 3> corner;
      for (int k = 0; k < 3; ++k) corner[k] = triangles_[t][k] == point ? place : at(triangles_[t][k]);
      least = std::min(least, quality(corner, size(triangles_[t])));
    }
    return least;
  }

  static double quality(const std::array<Point, 3>& corner, double size) {
    const auto squared = [](const Point& a, const Point& b) {
      const double x = b[0] - a[0], y = b[1] - a[1];
      return x * x + y * y;
    };
    const double ab = squared(corner[0], corner[1]), bc = squared(corner[1], corner[2]), ca = squared(corner[2], corner[0]);
    const double longest = std::max({ab, bc, ca}), product = ab * bc * ca, least = std::min({ab, bc, ca});
    const double area = twice_area(corner[0], corner[1], corner[2]);
    const double sine_of_smallest_angle = area / std::sqrt(product / least), altitude = area / std::sqrt(longest);
    return std::min(sine_of_smallest_angle, altitude_weight * altitude / size);
  }

  bool improve() {
    bool improved = false;
    for (std::uint32_t p = static_cast<std::uint32_t>(problem_.fixed); p < problem_.points.size(); ++p) {
      double best = quality(p, at(p));
      if (best >= good_quality) continue;
      double step = first_search_step * size_[p];
      for (int halving = 0; halving < search_halvings; ++halving, step /= 2)
        for (int k = 0; k < search_directions; ++k) {
          const double angle = 2 * std::numbers::pi * k / search_directions;
          const Point place{at(p)[0] + step * std::cos(angle), at(p)[1] + step * std::sin(angle)};
          const double found = quality(p, place);
          if (found <= best) continue;
          best = found;
          problem_.points[p] = place;
          moved_[p] = 1;
          improved = true;
        }
    }
    return improved;
  }

  PatchProblem& problem_;
  std::vector<PointTriple> triangles_;
  std::vector<double> size_;  // target edge length at each point
  std::vector<char> moved_;   // since then
  std::vector<std::vector<std::uint32_t>> incident_;
};

}  // namespace

std::vector<PointTriple> relax_patch(PatchProblem& problem) { return PatchRelaxation(problem).run(); }

}  // namespace fissura::structure
