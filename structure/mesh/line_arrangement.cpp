// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/line_arrangement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "common/errors.hpp"
#include "structure/mesh/line_checks.hpp"
#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {
namespace {

struct Segment {
  std::uint32_t line = 0;
  std::uint32_t begin = 0, end = 0;  // vertices
  std::vector<std::pair<double, std::uint32_t>> cuts;
};

class VertexSet {
 public:
  explicit VertexSet(double tolerance) : tolerance_(tolerance) {}

  std::uint32_t add(Point point) {
    if (const auto known = find(point)) return *known;
    const auto index = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    cells_[cell(point)].push_back(index);
    return index;
  }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  [[nodiscard]] Cell cell(Point point) const {
    return {std::llround(std::floor(point[0] / tolerance_)), std::llround(std::floor(point[1] / tolerance_))};
  }
  [[nodiscard]] std::optional<std::uint32_t> find(Point point) const {
    const Cell centre = cell(point);
    std::optional<std::uint32_t> found;
    for (std::int64_t i = centre.first - 1; i <= centre.first + 1; ++i)
      for (std::int64_t j = centre.second - 1; j <= centre.second + 1; ++j)
        if (const auto it = cells_.find({i, j}); it != cells_.end())
          for (const std::uint32_t v : it->second)
            if (std::hypot(points_[v][0] - point[0], points_[v][1] - point[1]) <= tolerance_ &&
                (!found || v < *found))
              found = v;
    return found;
  }

  double tolerance_;
  std::vector<Point> points_;
  std::map<Cell, std::vector<std::uint32_t>> cells_;
};

class Arranger {
 public:
  explicit Arranger(const Case& given)
      : given_(given),
        h_(given.mesh.fracture_size),
        tolerance_(touch_tolerance * h_),
        vertices_(tolerance_) {}

  LineArrangement arrange() {
    add_given_points();
    meet_all_pairs();
    cut_at_perforations();
    return {vertices_.points(), pieces()};
  }

 private:
  [[nodiscard]] const std::string& name(std::uint32_t line) const { return given_.fractures[line].name; }
  [[nodiscard]] Point at(std::uint32_t vertex) const { return vertices_.points()[vertex]; }

  [[nodiscard]] Point inside(Point point, std::uint32_t line) const {
    const double half[2] = {given_.domain.width / 2, given_.domain.height / 2};
    Point result = point;
    for (int k : {0, 1}) {
      if (!std::isfinite(point[k]) || std::abs(point[k]) > half[k] + tolerance_)
        throw InputError(fmt::format(
            "fracture '{}' has the point {} outside the domain of {} x {} m centred on the origin",
            name(line), text(point), given_.domain.width, given_.domain.height));
      if (std::abs(point[k]) > half[k] - tolerance_) result[k] = std::copysign(half[k], point[k]);
    }
    return result;
  }

  void add_given_points() {
    for (std::uint32_t line = 0; line < given_.fractures.size(); ++line) {
      const auto& points = given_.fractures[line].points;
      if (points.size() < 2)
        throw InputError(
            fmt::format("fracture '{}' needs at least two points, found {}", name(line), points.size()));
      std::uint32_t begin = vertices_.add(inside(points[0], line));
      for (std::size_t i = 1; i < points.size(); ++i) {
        const std::uint32_t end = vertices_.add(inside(points[i], line));
        if (begin == end)
          throw InputError(
              fmt::format("fracture '{}' has a stretch without length at {}", name(line), text(points[i])));
        segments_.push_back({line, begin, end, {{0.0, begin}, {1.0, end}}});
        begin = end;
      }
    }
  }

  void meet_all_pairs() {
    std::vector<std::uint32_t> order(segments_.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto low = [&](std::uint32_t s, int k) {
      return std::min(at(segments_[s].begin)[k], at(segments_[s].end)[k]);
    };
    const auto high = [&](std::uint32_t s, int k) {
      return std::max(at(segments_[s].begin)[k], at(segments_[s].end)[k]);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return low(a, 0) != low(b, 0) ? low(a, 0) < low(b, 0) : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && low(order[j], 0) <= high(order[i], 0) + tolerance_; ++j)
        if (low(order[j], 1) <= high(order[i], 1) + tolerance_ &&
            low(order[i], 1) <= high(order[j], 1) + tolerance_)
          meet(segments_[std::min(order[i], order[j])], segments_[std::max(order[i], order[j])]);
  }

  void meet(Segment& a, Segment& b) {
    std::vector<std::uint32_t> common;
    const auto touch = [&](std::uint32_t vertex, Segment& other) {
      if (distance_to_segment(at(vertex), at(other.begin), at(other.end)) > tolerance_) return;
      cut(other, vertex);
      if (std::find(common.begin(), common.end(), vertex) == common.end()) common.push_back(vertex);
    };
    touch(a.begin, b);
    touch(a.end, b);
    touch(b.begin, a);
    touch(b.end, a);
    if (common.size() > 1) throw shared_stretch(a.line, b.line, at(common[0]), at(common[1]));
    if (common.empty()) cross(a, b);
  }

  [[nodiscard]] InputError shared_stretch(std::uint32_t first, std::uint32_t second, Point from,
                                          Point to) const {
    if (first == second)
      return InputError(fmt::format("fracture '{}' runs back over itself between {} and {}", name(first),
                                    text(from), text(to)));
    return InputError(
        fmt::format("fractures '{}' and '{}' lie on one another between {} and {}: give the common "
                    "stretch to one of them",
                    name(first), name(second), text(from), text(to)));
  }

  void cross(Segment& a, Segment& b) {
    const Point p = at(a.begin), q = at(b.begin);
    const double ax = at(a.end)[0] - p[0], ay = at(a.end)[1] - p[1];
    const double bx = at(b.end)[0] - q[0], by = at(b.end)[1] - q[1];
    const double determinant = ax * by - ay * bx;
    if (determinant == 0) return;
    const double dx = q[0] - p[0], dy = q[1] - p[1];
    const double along_a = (dx * by - dy * bx) / determinant, along_b = (dx * ay - dy * ax) / determinant;
    if (along_a <= 0 || along_a >= 1 || along_b <= 0 || along_b >= 1) return;
    const std::uint32_t vertex = vertices_.add({p[0] + along_a * ax, p[1] + along_a * ay});
    cut(a, vertex);
    cut(b, vertex);
  }

  void cut(Segment& segment, std::uint32_t vertex) {
    if (vertex == segment.begin || vertex == segment.end) return;
    const Point p = at(segment.begin), q = at(segment.end), x = at(vertex);
    const double tx = q[0] - p[0], ty = q[1] - p[1];
    segment.cuts.emplace_back(((x[0] - p[0]) * tx + (x[1] - p[1]) * ty) / (tx * tx + ty * ty), vertex);
  }

  void cut_at_perforations() {
    for (const Perforation& perforation : given_.injection.perforations) {
      Segment* nearest = nullptr;
      double smallest = smallest_gap * h_;
      for (Segment& segment : segments_) {
        const double distance = distance_to_segment(perforation.position, at(segment.begin), at(segment.end));
        if (distance < smallest) {
          smallest = distance;
          nearest = &segment;
        }
      }
      if (nearest == nullptr) continue;
      const auto is_near = [&](const auto& entry) {
        return std::hypot(at(entry.second)[0] - perforation.position[0],
                          at(entry.second)[1] - perforation.position[1]) < smallest_gap * h_;
      };
      if (std::any_of(nearest->cuts.begin(), nearest->cuts.end(), is_near)) continue;
      const Point p = at(nearest->begin), q = at(nearest->end);
      const double tx = q[0] - p[0], ty = q[1] - p[1];
      const double along = ((perforation.position[0] - p[0]) * tx + (perforation.position[1] - p[1]) * ty) /
                           (tx * tx + ty * ty);
      cut(*nearest, vertices_.add({p[0] + along * tx, p[1] + along * ty}));
    }
  }

  std::vector<LinePiece> pieces() {
    std::vector<LinePiece> result;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> taken;
    for (Segment& segment : segments_) {
      std::sort(segment.cuts.begin(), segment.cuts.end());
      for (std::size_t i = 0; i + 1 < segment.cuts.size(); ++i) {
        const std::uint32_t begin = segment.cuts[i].second, end = segment.cuts[i + 1].second;
        if (begin == end) continue;
        const auto [other, is_new] = taken.try_emplace(std::minmax(begin, end), segment.line);
        if (!is_new) throw shared_stretch(other->second, segment.line, at(begin), at(end));
        result.push_back({begin, end, segment.line});
      }
    }
    return result;
  }

  const Case& given_;
  double h_, tolerance_;
  VertexSet vertices_;
  std::vector<Segment> segments_;
};

}  // namespace

LineArrangement arrange_lines(const Case& given) {
  LineArrangement lines = Arranger(given).arrange();
  check_gaps(lines, given);
  check_angles(lines, given);
  return lines;
}

}  // namespace fissura::structure
