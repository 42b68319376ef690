// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "common/case/case.hpp"

namespace fissura::structure {

/// A straight segment with a number added to every distance from it.
struct WeightedSegment {
  Point begin{}, end{};  ///< [m]
  double offset = 0;     ///< [m], >= 0
};

/// Distance of `point` from the segment begin-end [m].
double distance_to_segment(Point point, Point begin, Point end);

/// Finds the nearest of many segments in logarithmic time: a binary tree of boxes, split at the median of the
/// longer side. Constant after construction; equal distances give the segment that was named first.
class SegmentTree {
 public:
  SegmentTree() = default;
  explicit SegmentTree(std::vector<WeightedSegment> segments);

  struct Nearest {
    std::uint32_t segment = 0;  ///< index into the constructor's list
    double distance = 0;        ///< offset + distance [m]; infinite if there are no segments
  };

  /// The segment of smallest offset + distance from `point`.
  [[nodiscard]] Nearest nearest(Point point) const;

  /// Segments whose offset + distance from `point` is at most `distance` [m], in ascending order.
  [[nodiscard]] std::vector<std::uint32_t> within(Point point, double distance) const;

 private:
  struct Box {
    Point low{}, high{};
    double offset = 0;
    std::uint32_t first = 0, last = 0;  // of a leaf: range of order_; of an inner box: its two children
    bool leaf = false;
  };
  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  [[nodiscard]] double distance_to(std::uint32_t segment, Point point) const;

  std::vector<WeightedSegment> segments_;
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

}  // namespace fissura::structure
