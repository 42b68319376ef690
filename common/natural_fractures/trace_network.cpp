// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/trace_network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/case/line_limits.hpp"

namespace fissura {

namespace {

constexpr double clearance_in_sizes = 0.5;
constexpr double gap_in_sizes = 0.25;
constexpr double beyond_smallest_gap = 1.2;
constexpr double within_touch_tolerance = 0.1;
constexpr double beyond_smallest_angle = 2;  // degrees
constexpr double shortest_in_sizes = 2;
constexpr double margin_in_sizes = 1;

double angle_between(Point a, Point b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

// The directions in which a segment leaves a place on it.
std::vector<Point> rays(const PlanarSegment& segment, Point at, double same_place) {
  const Point along = direction(segment);
  std::vector<Point> result;
  if (length(difference(at, segment.end)) > same_place) result.push_back(along);
  if (length(difference(at, segment.begin)) > same_place) result.push_back(scaled(along, -1));
  return result;
}

std::optional<Point> crossing(const PlanarSegment& a, const PlanarSegment& b) {
  const Point along_a = difference(a.end, a.begin), along_b = difference(b.end, b.begin);
  const double determinant = cross(along_a, along_b);
  if (determinant == 0) return {};
  const Point between = difference(b.begin, a.begin);
  const double on_a = cross(between, along_b) / determinant, on_b = cross(between, along_a) / determinant;
  if (on_a <= 0 || on_a >= 1 || on_b <= 0 || on_b >= 1) return {};
  return sum(a.begin, scaled(along_a, on_a));
}

/// One look at a trace and the lines near it.
class Inspection {
 public:
  Inspection(const TraceNetwork& network, const PlanarSegment& trace, Point origin)
      : network_(network),
        limits_(network.limits()),
        trace_(trace),
        along_(direction(trace)),
        origin_(origin),
        begin_(place(trace.begin)),
        end_(place(trace.end)) {}

  std::optional<Conflict> first_conflict(std::span<const std::size_t> lines) {
    for (const std::size_t index : lines) {
      const TraceNetwork::Line& line = network_.line(index);
      const Meeting here = meeting(trace_, line.segment, limits_.same_place());
      if (auto conflict =
              here.kind == Meeting::Kind::none ? passing(index, line) : meeting_conflict(index, line, here))
        return conflict;
    }
    return crowding();
  }

 private:
  struct Place {
    double along;
    std::size_t line;
    Point at;
  };

  [[nodiscard]] double place(Point point) const { return dot(difference(point, origin_), along_); }

  /// A conflict at a place: one of every trace that passes through it.
  [[nodiscard]] Conflict at_place(Conflict::Kind kind, std::size_t line, Point at, double amount) const {
    const double along = place(at), slack = limits_.clearance(limits_.natural_size);
    Conflict conflict{kind, line, at, amount, {}};
    if (along > begin_ + slack && along < end_ - slack) conflict.wherever = {along - slack, along + slack};
    return conflict;
  }

  [[nodiscard]] std::optional<Conflict> passing(std::size_t index, const TraceNetwork::Line& line) const {
    const double size = std::min(line.size, limits_.natural_size);
    const double apart = distance(trace_, line.segment);
    if (apart >= limits_.clearance(size)) return {};
    Point at = trace_.begin;
    double least = distance(trace_.begin, line.segment);
    if (const double other = distance(trace_.end, line.segment); other < least) {
      least = other;
      at = trace_.end;
    }
    for (const Point end : {line.segment.begin, line.segment.end})
      if (const double other = distance(end, trace_); other < least) {
        least = other;
        at = end;
      }
    return at_place(Conflict::Kind::near, index, at, apart);
  }

  [[nodiscard]] std::optional<Conflict> meeting_conflict(std::size_t index, const TraceNetwork::Line& line,
                                                         const Meeting& here) {
    if (here.kind == Meeting::Kind::stretch || here.angle < limits_.angle())
      return at_place(Conflict::Kind::angle, index, here.at,
                      here.kind == Meeting::Kind::stretch ? 0 : here.angle);
    places_.push_back({place(here.at), index, here.at});
    const double size = std::min(line.size, limits_.natural_size);
    for (const Point other : line.places) {
      const double apart = length(difference(other, here.at));
      if (apart <= limits_.same_place()) continue;
      if (apart < limits_.clearance(line.size))
        return at_place(Conflict::Kind::crowded, index, here.at, apart);
      if (const double to_trace = distance(other, trace_); to_trace < limits_.gap(size))
        return at_place(Conflict::Kind::near, index, other, to_trace);
    }
    for (const Point end : {trace_.begin, trace_.end}) {
      if (length(difference(end, here.at)) <= limits_.same_place()) continue;
      if (const double to_line = distance(end, line.segment); to_line < limits_.gap(size))
        return Conflict{Conflict::Kind::near, index, end, to_line, {}};
    }
    return {};
  }

  [[nodiscard]] std::optional<Conflict> crowding() {
    std::sort(places_.begin(), places_.end(),
              [](const Place& a, const Place& b) { return a.along < b.along; });
    const double same = limits_.same_place(), clearance = limits_.clearance(limits_.natural_size);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Place& one = places_[i];
      for (const double end : {begin_, end_})
        if (const double apart = std::abs(end - one.along); apart > same && apart < clearance)
          return Conflict{Conflict::Kind::crowded, one.line, one.at, apart, {}};
      if (i == 0) continue;
      if (const double apart = one.along - places_[i - 1].along; apart > same && apart < clearance)
        return Conflict{Conflict::Kind::crowded,
                        one.line,
                        one.at,
                        apart,
                        {{places_[i - 1].along - same, one.along + same}}};
    }
    return wedge(same);
  }

  /// A meeting with one line that lies near another that the trace also meets, in the wedge between the two.
  [[nodiscard]] std::optional<Conflict> wedge(double same) const {
    for (const Place& one : places_)
      for (const Place& other : places_) {
        if (std::abs(one.along - other.along) <= same) continue;
        const TraceNetwork::Line& line = network_.line(other.line);
        const double apart = distance(one.at, line.segment);
        if (apart >= limits_.gap(std::min(line.size, limits_.natural_size))) continue;
        return Conflict{Conflict::Kind::near,
                        other.line,
                        one.at,
                        apart,
                        {{std::min(one.along, other.along) - same, std::max(one.along, other.along) + same}}};
      }
    return {};
  }

  const TraceNetwork& network_;
  const NetworkLimits& limits_;
  PlanarSegment trace_;
  Point along_, origin_;
  double begin_, end_;
  std::vector<Place> places_;  // where the trace meets lines
};

}  // namespace

double NetworkLimits::same_place() const {
  return within_touch_tolerance * touch_tolerance * fracture_size;
}
double NetworkLimits::clearance(double size) const {
  return std::max(clearance_in_sizes * size, beyond_smallest_gap * smallest_gap * fracture_size);
}
double NetworkLimits::gap(double size) const {
  return std::max(gap_in_sizes * size, beyond_smallest_gap * smallest_gap * fracture_size);
}
double NetworkLimits::angle() const {
  return (smallest_line_angle + beyond_smallest_angle) * std::numbers::pi / 180;
}
double NetworkLimits::shortest() const {
  return shortest_in_sizes * natural_size;
}
double NetworkLimits::margin() const {
  return margin_in_sizes * natural_size;
}

Meeting meeting(const PlanarSegment& a, const PlanarSegment& b, double same_place) {
  std::vector<Point> common;
  const auto add = [&](Point end, const PlanarSegment& other) {
    if (distance(end, other) > same_place) return;
    for (const Point known : common)
      if (length(difference(known, end)) <= 2 * same_place) return;
    common.push_back(end);
  };
  add(b.begin, a);
  add(b.end, a);
  add(a.begin, b);
  add(a.end, b);
  if (common.size() > 1) return {Meeting::Kind::stretch, scaled(sum(common[0], common[1]), 0.5), 0};
  if (common.empty()) {
    const auto at = crossing(a, b);
    if (!at) return {};
    common.push_back(*at);
  }
  Meeting result{Meeting::Kind::point, common[0], std::numbers::pi};
  for (const Point one : rays(a, common[0], 2 * same_place))
    for (const Point other : rays(b, common[0], 2 * same_place))
      result.angle = std::min(result.angle, angle_between(one, other));
  return result;
}

void TraceNetwork::add(const PlanarSegment& segment, double size, const std::string& name,
                       std::span<const Point> places) {
  Line added{segment, size, name, {segment.begin, segment.end}};
  added.places.insert(added.places.end(), places.begin(), places.end());
  const auto add_place = [&](Line& line, Point at) {
    for (const Point known : line.places)
      if (length(difference(known, at)) <= limits_.same_place()) return;
    line.places.push_back(at);
  };
  for (const std::size_t index : near(segment, limits_.same_place())) {
    const Meeting here = meeting(segment, lines_[index].segment, limits_.same_place());
    if (here.kind != Meeting::Kind::point) continue;
    add_place(added, here.at);
    add_place(lines_[index], here.at);
  }
  lines_.push_back(std::move(added));
}

std::vector<std::size_t> TraceNetwork::near(const PlanarSegment& segment, double apart) const {
  std::vector<std::size_t> result;
  for (std::size_t index = 0; index < lines_.size(); ++index) {
    const PlanarSegment& other = lines_[index].segment;
    bool boxes_meet = true;
    for (const std::size_t k : {0u, 1u})
      boxes_meet =
          boxes_meet &&
          std::max(segment.begin[k], segment.end[k]) + apart >= std::min(other.begin[k], other.end[k]) &&
          std::max(other.begin[k], other.end[k]) + apart >= std::min(segment.begin[k], segment.end[k]);
    if (boxes_meet) result.push_back(index);
  }
  return result;
}

std::optional<Conflict> TraceNetwork::conflict(const PlanarSegment& segment,
                                               std::span<const std::size_t> lines, Point origin) const {
  return Inspection(*this, segment, origin).first_conflict(lines);
}

}  // namespace fissura
