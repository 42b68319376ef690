// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

/// A straight stretch of a fracture line and the length of the mesh edges on it.
struct SizedSegment {
  Point begin{}, end{};    ///< [m]
  double edge_length = 0;  ///< [m], > 0
};

/// Target edge length of the mesh,
///   h(x) = min(far_size, fracture_size + gradation max(0, d(x) - corridor)),
/// d the distance to the nearest fracture line. Where the edges prescribed on a line are much shorter than
/// fracture_size (between close crossings), h starts at their length and grows from there without a corridor.
/// Besides, h is at most
///   tip_size + tip_gradation max(0, distance from a growing tip - tip_radius)   and
///   size of a refinement + gradation (distance from its rectangle) .
/// h is Lipschitz continuous, so that neighbouring triangles differ little in size.
class SizeField {
 public:
  /// `tips` are the ends of lines that grow freely.
  SizeField(const MeshControls& controls, std::span<const SizedSegment> lines, std::vector<Point> tips);

  /// h at `point` [m].
  [[nodiscard]] double size(Point point) const;

  /// Length of the edges to be prescribed on a line at `point`: fracture_size, or what tips and refinements
  /// ask for if that is less [m].
  [[nodiscard]] double size_on_line(Point point) const;

  /// Distance of `point` from the nearest fracture line [m]; infinite without lines.
  [[nodiscard]] double distance(Point point) const { return lines_.nearest(point).distance; }

  /// Index of the nearest of the constructor's lines.
  [[nodiscard]] std::uint32_t nearest_line(Point point) const { return lines_.nearest(point).segment; }

  /// Target size and distance in one search.
  struct Sample {
    double size = 0, distance = 0;  ///< [m]
  };
  [[nodiscard]] Sample sample(Point point) const;

 private:
  [[nodiscard]] double refined(Point point, double size) const;

  MeshControls controls_;
  std::vector<Point> tips_;
  SegmentTree lines_;
  SegmentTree short_stretches_;
};

}  // namespace fissura::structure
