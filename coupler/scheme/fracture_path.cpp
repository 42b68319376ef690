// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/fracture_path.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace fissura::coupler {

namespace {

/// Part of the fracture element size below which a point lies on a line, and part of the mean stress below
/// which a difference of principal stresses is none.
constexpr double same_place = 1e-6, isotropic = 1e-9;
constexpr std::size_t segments_at_the_end = 3;

Point place(const NetworkNode& node) {
  return {node.x, node.y};
}

Point between(const Point& from, const Point& to) {
  return {to[0] - from[0], to[1] - from[1]};
}

/// Of two directions, in [0, pi].
double angle(const Point& a, const Point& b) {
  return std::atan2(std::abs(a[0] * b[1] - a[1] * b[0]), a[0] * b[0] + a[1] * b[1]);
}

/// Of two axes, in [0, pi/2].
double axis_angle(const Point& a, const Point& b) {
  const double between_directions = angle(a, b);
  return std::min(between_directions, std::numbers::pi - between_directions);
}

double distance_to_segment(const Point& a, const Point& b, const Point& p) {
  const Point along = between(a, b), to = between(a, p);
  const double square = along[0] * along[0] + along[1] * along[1];
  const double s = std::clamp((to[0] * along[0] + to[1] * along[1]) / square, 0.0, 1.0);
  return std::hypot(to[0] - s * along[0], to[1] - s * along[1]);
}

double distance_to_line(const FractureLine& line, const Point& p) {
  double least = distance_to_segment(line.points[0], line.points[1], p);
  for (std::size_t i = 2; i < line.points.size(); ++i)
    least = std::min(least, distance_to_segment(line.points[i - 1], line.points[i], p));
  return least;
}

const FractureLine* slit_of(const Case& run_case) {
  const FractureLine* slit = nullptr;
  double least = 0;
  for (const FractureLine& line : run_case.fractures) {
    if (line.kind != FractureKind::open) continue;
    if (run_case.injection.perforations.empty()) return &line;
    const double distance = distance_to_line(line, run_case.injection.perforations.front().position);
    if (slit != nullptr && distance >= least) continue;
    slit = &line;
    least = distance;
  }
  return slit;
}

/// Nothing where the horizontal stress is isotropic.
std::optional<Point> axis_of_greatest_compression(const InSitu& in_situ, const Point& at) {
  const auto stress = [&](std::size_t k) {
    return in_situ.stress[k] + in_situ.stress_gradient[k][0] * at[0] + in_situ.stress_gradient[k][1] * at[1];
  };
  const double half_difference = (stress(0) - stress(1)) / 2;
  const double mean = std::abs(stress(0) + stress(1)) / 2;
  if (std::hypot(half_difference, stress(2)) <= isotropic * mean) return std::nullopt;
  const double of_greatest_tension = std::atan2(stress(2), half_difference) / 2;
  return Point{-std::sin(of_greatest_tension), std::cos(of_greatest_tension)};
}

class PathFinder {
 public:
  PathFinder(const FractureNetwork& network, const Case& run_case) : network_(network), case_(run_case) {}

  FracturePath find() {
    find_grown();
    const FractureLine* slit = slit_of(case_);
    if (slit == nullptr || path_.grown.empty()) return std::move(path_);
    const Point &begin = slit->points.front(), &end = slit->points.back();
    const Point across = between(begin, end);
    const Point axis =
        axis_of_greatest_compression(case_.in_situ, {(begin[0] + end[0]) / 2, (begin[1] + end[1]) / 2})
            .value_or(across);
    const std::size_t last = slit->points.size() - 1;
    measure(wing_from(end, between(slit->points[last - 1], end)), begin, across, axis);
    measure(wing_from(begin, between(slit->points[1], begin)), end, between(end, begin), axis);
    return std::move(path_);
  }

 private:
  [[nodiscard]] Point position(NodeId id) const { return place(network_.nodes()[network_.index_of(id)]); }
  [[nodiscard]] double tolerance() const { return same_place * case_.mesh.fracture_size; }

  [[nodiscard]] bool on_an_open_line(const NetworkSegment& segment) const {
    const Point a = position(segment.node_a), b = position(segment.node_b);
    const Point middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    return std::any_of(case_.fractures.begin(), case_.fractures.end(), [&](const FractureLine& line) {
      return line.kind == FractureKind::open && distance_to_line(line, a) <= tolerance() &&
             distance_to_line(line, middle) <= tolerance() && distance_to_line(line, b) <= tolerance();
    });
  }

  void find_grown() {
    for (std::size_t s = 0; s < network_.segments().size(); ++s) {
      const NetworkSegment& segment = network_.segments()[s];
      if (segment.kind == SegmentKind::hydraulic && !on_an_open_line(segment)) path_.grown.push_back(s);
    }
    std::set<std::size_t> nodes;
    for (const std::size_t s : path_.grown) {
      nodes.insert({network_.index_of(network_.segments()[s].node_a),
                    network_.index_of(network_.segments()[s].node_b)});
      grown_at_.emplace(network_.segments()[s].node_a, s);
      grown_at_.emplace(network_.segments()[s].node_b, s);
    }
    path_.nodes.assign(nodes.begin(), nodes.end());
  }

  /// The nodes of the wing from `slit_end` on; that alone if none has grown.
  [[nodiscard]] std::vector<Point> wing_from(const Point& slit_end, Point direction) const {
    std::vector<Point> wing{slit_end};
    std::optional<NodeId> here;
    for (const NetworkNode& node : network_.nodes())
      if (std::hypot(node.x - slit_end[0], node.y - slit_end[1]) <= tolerance()) here = node.id;
    std::set<std::size_t> taken;
    while (here) {
      std::optional<std::size_t> next;
      double least_turn = 0;
      const auto [first, last] = grown_at_.equal_range(*here);
      for (auto entry = first; entry != last; ++entry) {
        const std::size_t s = entry->second;
        if (taken.contains(s)) continue;
        const double turn = angle(direction, between(wing.back(), position(across(s, *here))));
        if (next && turn >= least_turn) continue;
        next = s;
        least_turn = turn;
      }
      if (!next) break;
      taken.insert(*next);
      here = across(*next, *here);
      direction = between(wing.back(), position(*here));
      wing.push_back(position(*here));
    }
    return wing;
  }

  [[nodiscard]] NodeId across(std::size_t segment, NodeId node) const {
    const NetworkSegment& ends = network_.segments()[segment];
    return ends.node_a == node ? ends.node_b : ends.node_a;
  }

  /// `outwards` leads from `other_end` of the slit to the one where the wing begins.
  void measure(const std::vector<Point>& wing, const Point& other_end, const Point& outwards,
               const Point& axis) {
    if (wing.size() < 2) return;
    const double length = std::hypot(outwards[0], outwards[1]);
    for (const Point& node : wing) {
      const Point to = between(other_end, node);
      path_.deviation =
          std::max(path_.deviation, std::abs(outwards[0] * to[1] - outwards[1] * to[0]) / length);
    }
    path_.chord_angle = std::max(path_.chord_angle, angle(outwards, between(wing.front(), wing.back())));
    path_.first_angle = std::max(path_.first_angle, axis_angle(axis, between(wing[0], wing[1])));
    const std::size_t before_end = wing.size() - 1 - std::min(segments_at_the_end, wing.size() - 1);
    path_.end_angle = std::max(path_.end_angle, axis_angle(axis, between(wing[before_end], wing.back())));
  }

  const FractureNetwork& network_;
  const Case& case_;
  FracturePath path_;
  std::multimap<NodeId, std::size_t> grown_at_;  ///< grown segments at a node
};

}  // namespace

FracturePath fracture_path(const FractureNetwork& network, const Case& run_case) {
  return PathFinder(network, run_case).find();
}

double grown_length(const FractureNetwork& network, const FracturePath& path,
                    const std::vector<double>& opened, const std::vector<double>& broken) {
  double sum = 0;
  for (const std::size_t i : path.nodes) {
    const double length = network.nodes()[i].lumped_length;
    if (broken[i] > 0)
      sum += length;
    else if (opened[i] > 0)
      sum += length / 2;
  }
  return sum;
}

}  // namespace fissura::coupler
