// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "common/case/check_case.hpp"

namespace fissura::input {

namespace {

/// Part of the fracture element size below which two places are one.
constexpr double same_place = 1e-6;

std::string text(const Point& point) {
  return fmt::format("({:.6g}, {:.6g}) m", point[0], point[1]);
}

double distance(const Point& a, const Point& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

double cross(const Point& origin, const Point& a, const Point& b) {
  return (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0]);
}

/// Place of the foot of the perpendicular from `p` on a-b, as length from a along a-b.
double along(const Point& a, const Point& b, const Point& p) {
  return ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / distance(a, b);
}

double distance_to_segment(const Point& a, const Point& b, const Point& p) {
  const double length = distance(a, b);
  if (!(length > 0)) return distance(a, p);
  const double s = std::clamp(along(a, b, p), 0.0, length) / length;
  return distance({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}, p);
}

double length_of(const FractureLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) length += distance(line.points[i - 1], line.points[i]);
  return length;
}

struct Segment {
  std::size_t line;
  Point a, b;
};

/// Whether two segments lie on one another over more than `tolerance`.
bool overlap(const Segment& first, const Segment& second, double tolerance) {
  const double length = distance(first.a, first.b);
  if (!(length > tolerance)) return false;
  if (std::abs(cross(first.a, first.b, second.a)) > tolerance * length) return false;
  if (std::abs(cross(first.a, first.b, second.b)) > tolerance * length) return false;
  const auto [begin, end] =
      std::minmax({along(first.a, first.b, second.a), along(first.a, first.b, second.b)});
  return std::min(end, length) - std::max(begin, 0.0) > tolerance;
}

class GeometryCheck {
 public:
  GeometryCheck(const Case& value, const SourceValue& document, FaultList& faults)
      : case_(value),
        document_(document),
        faults_(faults),
        tolerance_(same_place * value.mesh.fracture_size) {}

  void sizes() const {
    const double smaller_side = std::min(case_.domain.width, case_.domain.height);
    if (case_.mesh.fracture_size > case_.mesh.far_size)
      refuse("mesh.fracture_size", fmt::format("{} m", case_.mesh.fracture_size),
             fmt::format("at most mesh.far_size, {} m", case_.mesh.far_size));
    if (case_.mesh.natural_size > case_.mesh.far_size)
      refuse("mesh.natural_size", fmt::format("{} m", case_.mesh.natural_size),
             fmt::format("at most mesh.far_size, {} m", case_.mesh.far_size));
    if (case_.mesh.far_size > smaller_side)
      refuse(
          "mesh.far_size", fmt::format("{} m", case_.mesh.far_size),
          fmt::format("at most the smaller side of the domain, {} m: no element would have an area inside it",
                      smaller_side));
  }

  void line(std::size_t index) const {
    const FractureLine& fracture = case_.fractures[index];
    const std::string key = key_of_points(index);
    for (std::size_t i = 0; i < fracture.points.size(); ++i) {
      const Point& point = fracture.points[i];
      const std::string place = fmt::format("{}[{}]", key, i);
      const double beyond = std::max(std::abs(point[0]) - case_.domain.width / 2,
                                     std::abs(point[1]) - case_.domain.height / 2);
      const bool may_end_on_side = fracture.kind == FractureKind::natural;
      if (beyond > 0 || (beyond == 0 && !may_end_on_side))
        refuse(place, text(point),
               fmt::format("a point inside the domain, |x| < {} m and |y| < {} m", case_.domain.width / 2,
                           case_.domain.height / 2));
      const auto twin =
          std::find_if(fracture.points.begin(), fracture.points.begin() + static_cast<std::ptrdiff_t>(i),
                       [&](const Point& other) { return distance(other, point) <= tolerance_; });
      if (twin - fracture.points.begin() != static_cast<std::ptrdiff_t>(i))
        refuse(place, fmt::format("{} once more", text(point)),
               "every point of a line once: a piece of line needs a length");
    }
    const double length = length_of(fracture);
    if (!fracture.points.empty() && length < case_.mesh.fracture_size)
      refuse(key, fmt::format("a line of {:.6g} m", length),
             fmt::format("at least one element, mesh.fracture_size = {} m", case_.mesh.fracture_size));
  }

  void overlaps() const {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < case_.fractures.size(); ++i)
      for (std::size_t j = 1; j < case_.fractures[i].points.size(); ++j)
        segments.push_back({i, case_.fractures[i].points[j - 1], case_.fractures[i].points[j]});
    std::sort(segments.begin(), segments.end(),
              [](const Segment& a, const Segment& b) { return west(a) < west(b); });
    std::set<std::pair<std::size_t, std::size_t>> reported;
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t j = i + 1; j < segments.size() && west(segments[j]) <= east(segments[i]); ++j) {
        const auto lines = std::minmax(segments[i].line, segments[j].line);
        if (!overlap(segments[i], segments[j], tolerance_)) continue;
        if (!reported.emplace(lines).second) continue;
        refuse(key_of_points(lines.second),
               "a line on top of fracture \"" + case_.fractures[lines.first].name + "\"",
               "lines that share single points at most: no area lies between these");
      }
  }

  void perforations() const {
    for (std::size_t i = 0; i < case_.injection.perforations.size(); ++i) {
      const Point& position = case_.injection.perforations[i].position;
      const std::string key = fmt::format("injection.perforation[{}].position", i);
      const std::optional<Neighbour> nearest = nearest_open(position);
      const bool readable = !case_.fractures.empty() || member_of(document_, "fracture") == nullptr;
      if (!nearest && readable) refuse(key, text(position), "a point on an open fracture; the case has none");
      if (nearest && nearest->distance > tolerance_)
        refuse(key, text(position),
               fmt::format("a point on an open fracture; the nearest, \"{}\", is {:.6g} m away",
                           nearest->name, nearest->distance));
    }
  }

 private:
  static double west(const Segment& segment) { return std::min(segment.a[0], segment.b[0]); }
  static double east(const Segment& segment) { return std::max(segment.a[0], segment.b[0]); }

  struct Neighbour {
    std::string name;
    double distance;
  };

  /// The nearest open line; at distance not-a-number if that cannot be told.
  [[nodiscard]] std::optional<Neighbour> nearest_open(const Point& position) const {
    std::optional<Neighbour> nearest;
    for (const FractureLine& line : case_.fractures) {
      if (line.kind != FractureKind::open) continue;
      if (!nearest) nearest = Neighbour{line.name, std::numeric_limits<double>::quiet_NaN()};
      for (std::size_t j = 1; j < line.points.size(); ++j) {
        const double distance = distance_to_segment(line.points[j - 1], line.points[j], position);
        if (!(nearest->distance <= distance)) *nearest = {line.name, distance};
      }
    }
    return nearest;
  }

  [[nodiscard]] std::string key_of_points(std::size_t index) const {
    const std::string fracture = fmt::format("fracture[{}]", index);
    const SourceMember* all = member_of(document_, "fracture");
    const auto* array = all == nullptr ? nullptr : std::get_if<SourceArray>(&all->value.content);
    const bool in_file = array != nullptr && index < array->elements.size() &&
                         member_of(array->elements[index], "file") != nullptr;
    return fracture + (in_file ? ".file" : ".points");
  }

  void refuse(const std::string& key, const std::string& found, const std::string& expected) const {
    faults_.push_back({position_of(document_, key), key, found, expected, ""});
  }

  const Case& case_;
  const SourceValue& document_;
  FaultList& faults_;
  double tolerance_;
};

}  // namespace

void check_geometry(const Case& value, const SourceValue& document, FaultList& faults) {
  const GeometryCheck check(value, document, faults);
  check.sizes();
  for (std::size_t i = 0; i < value.fractures.size(); ++i) check.line(i);
  check.overlaps();
  check.perforations();
}

}  // namespace fissura::input
