// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

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
/// h is Lipschitz continuous, so that neighbouring triangles differ little in size.
class SizeField {
 public:
  SizeField(const MeshControls& controls, std::span<const SizedSegment> lines);

  /// h at `point` [m].
  [[nodiscard]] double size(Point point) const;

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
  MeshControls controls_;
  SegmentTree lines_;
  SegmentTree short_stretches_;
};

}  // namespace fissura::structure
