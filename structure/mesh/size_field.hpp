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
  double size = 0;  ///< target edge length along its line [m], >= edge_length but for rounding to whole edges
};

/// Target edge length along a fracture line: natural_size (fracture_size where that is 0) for natural
/// fractures, else fracture_size [m].
double size_along(FractureKind kind, const MeshControls& controls);

/// Target edge length of the mesh,
///   h(x) = min(far_size, min over k of size_k + gradation max(0, d_k(x) - corridor)),
/// size_k and d_k the target edge length along fracture line k and the distance from it. Where the edges
/// prescribed on a line are much shorter than that (between close crossings), h starts at their length and
/// grows from there without a corridor. Besides, h is at most
///   tip_size + tip_gradation max(0, distance from a growing tip - tip_radius)   and
///   size of a refinement + gradation (distance from its rectangle) .
/// h is Lipschitz continuous, so that neighbouring triangles differ little in size.
class SizeField {
 public:
  /// `tips` are the ends of lines that grow freely.
  SizeField(const MeshControls& controls, std::span<const SizedSegment> lines, std::vector<Point> tips);

  /// h at `point` [m].
  [[nodiscard]] double size(Point point) const;

  /// Length of the edges to be prescribed at `point` on a line with target edge length `size`: that, or what
  /// finer lines, tips and refinements ask for if it is less [m].
  [[nodiscard]] double size_on_line(Point point, double size) const;

  /// Distance of `point` from the nearest fracture line [m]; infinite without lines.
  [[nodiscard]] double distance(Point point) const { return sample(point).distance; }

  /// Target size and distance in one search.
  struct Sample {
    double size = 0, distance = 0;  ///< [m]
  };
  [[nodiscard]] Sample sample(Point point) const;

 private:
  /// Lines of one target edge length.
  struct SizeGroup {
    double size = 0;
    SegmentTree lines;
  };
  [[nodiscard]] double graded(double size, double distance) const;
  [[nodiscard]] double refined(Point point, double size) const;

  MeshControls controls_;
  std::vector<Point> tips_;
  std::vector<SizeGroup> groups_;  // finest first
  SegmentTree short_stretches_;
};

}  // namespace fissura::structure
