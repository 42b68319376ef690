// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

/// Target edge length around the segment that is inserted at a tip:
///   h(x) = tip_size + tip_gradation max(0, d(x) - tip_radius) ,
/// d the distance from the segment. Farther away the mesh may be as coarse as it is.
class TipSizeField {
 public:
  /// @param extra_radius  added to tip_radius [m]
  TipSizeField(const MeshControls& controls, const Point& begin, const Point& end, double extra_radius)
      : begin_(begin),
        end_(end),
        size_(controls.tip_size),
        radius_(controls.tip_radius + extra_radius),
        gradation_(controls.tip_gradation) {}

  [[nodiscard]] double size(const Point& at) const {
    const double beyond = distance_to_segment(at, begin_, end_) - radius_;
    return beyond > 0 ? size_ + gradation_ * beyond : size_;
  }

  /// Farther from the segment than this an element of this size is never too coarse [m].
  [[nodiscard]] double reach(double size) const { return radius_ + (size - size_) / gradation_; }

 private:
  Point begin_, end_;
  double size_, radius_, gradation_;
};

}  // namespace fissura::structure
