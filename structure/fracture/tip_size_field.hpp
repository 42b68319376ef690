// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

/// Target edge length around the segment that is inserted at a tip:
///   h(x) = tip_size + tip_gradation max(0, d(x) - tip_radius) ,
/// d the distance from the segment. Farther away the mesh may be as coarse as it is.
class TipSizeField {
 public:
  TipSizeField(const MeshControls& controls, const Point& begin, const Point& end)
      : begin_(begin),
        end_(end),
        size_(controls.tip_size),
        radius_(controls.tip_radius),
        gradation_(controls.tip_gradation) {}

  [[nodiscard]] double size(const Point& at) const {
    const double beyond = distance_to_segment(at, begin_, end_) - radius_;
    return beyond > 0 ? size_ + gradation_ * beyond : size_;
  }

  [[nodiscard]] double gradation() const { return gradation_; }
  [[nodiscard]] double tip_size() const { return size_; }

 private:
  Point begin_, end_;
  double size_, radius_, gradation_;
};

/// Target edge length inside a patch: that of the tip, but not much more than the edges that stay,
///   h(x) = min(tip(x), max(0.85 tip_size, min over edges (length + tip_gradation distance))) .
/// The bound keeps a short edge from making the mesh finer with every insertion.
class PatchSizeField {
 public:
  /// @param edges  that stay: their two ends [m]
  PatchSizeField(const TipSizeField& tip, const std::vector<std::pair<Point, Point>>& edges) : tip_(tip) {
    std::vector<WeightedSegment> segments;
    for (const auto& [begin, end] : edges)
      segments.push_back({begin, end, std::hypot(end[0] - begin[0], end[1] - begin[1]) / tip.gradation()});
    edges_ = SegmentTree(std::move(segments));
  }

  [[nodiscard]] double size(const Point& at) const {
    constexpr double finest = 0.85;  // of the size at the tip
    return std::min(tip_.size(at), std::max(finest * tip_.tip_size(), tip_.gradation() * edges_.nearest(at).distance));
  }

 private:
  TipSizeField tip_;
  SegmentTree edges_;
};

}  // namespace fissura::structure
