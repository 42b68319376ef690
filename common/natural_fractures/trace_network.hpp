// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/natural_fractures/planar_segment.hpp"

namespace fissura {

/// What lines that are to be meshed must keep from one another. Wider than what the mesh asks for
/// (line_limits.hpp), so that elements between lines do not become much smaller than those along them.
/// Lengths in m.
struct NetworkLimits {
  double fracture_size = 0;
  double natural_size = 0;

  /// Two places are one.
  [[nodiscard]] double same_place() const;
  /// Least distance between lines that do not meet, and along a line between places where it meets others or
  /// ends; `size` is the element size along the finer of the lines.
  [[nodiscard]] double clearance(double size) const;
  /// Least distance of a line from the end of another that it meets elsewhere.
  [[nodiscard]] double gap(double size) const;
  /// Least angle at which lines meet [rad].
  [[nodiscard]] double angle() const;
  /// Shortest trace.
  [[nodiscard]] double shortest() const;
  /// Least distance of an end from the sides of the domain.
  [[nodiscard]] double margin() const;
};

/// Why a trace cannot be where it is.
struct Conflict {
  enum class Kind { near, angle, crowded };
  Kind kind = Kind::near;
  std::size_t line = 0;  ///< the line in the way
  Point at{};            ///< [m]
  double amount = 0;     ///< the distance [m], or the angle [rad]
  /// Any trace on the same axis that covers the stretch between these places along it is in the same conflict
  /// [m]; nothing if that depends on where it ends.
  std::optional<std::array<double, 2>> wherever;
};

/// Straight lines that keep the limits from one another, and the places where they meet.
class TraceNetwork {
 public:
  explicit TraceNetwork(const NetworkLimits& limits) : limits_(limits) {}

  struct Line {
    PlanarSegment segment;
    double size = 0;  ///< element size along it [m]
    std::string name;
    std::vector<Point> places;  ///< ends, and where it meets other lines, without order
  };

  /// Adds a line, whatever its conflicts. `places` are given besides its ends and the places where it meets
  /// lines that are there.
  void add(const PlanarSegment& segment, double size, const std::string& name, std::span<const Point> places);

  /// Lines that come within `distance` of a segment [m], in ascending order.
  [[nodiscard]] std::vector<std::size_t> near(const PlanarSegment& segment, double distance) const;

  /// The first conflict of a natural fracture at `segment` with `lines`, which must hold all that could be
  /// near it. Places along it count from `origin` in its own direction.
  [[nodiscard]] std::optional<Conflict> conflict(const PlanarSegment& segment,
                                                 std::span<const std::size_t> lines, Point origin) const;

  [[nodiscard]] const Line& line(std::size_t index) const { return lines_[index]; }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] const NetworkLimits& limits() const { return limits_; }

 private:
  NetworkLimits limits_;
  std::vector<Line> lines_;
};

/// Where two segments meet: an end of one on the other, or a crossing.
struct Meeting {
  enum class Kind { none, point, stretch };
  Kind kind = Kind::none;
  Point at{};        ///< [m]
  double angle = 0;  ///< least angle between the rays that leave the point along both [rad]
};

/// `same_place` is the distance within which an end lies on a segment [m]. @pre both have a length beyond it
Meeting meeting(const PlanarSegment& a, const PlanarSegment& b, double same_place);

}  // namespace fissura
