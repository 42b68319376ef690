// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/segment_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace fissura::structure {
namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr std::size_t stack_size = 128;

double distance_to_box(Point point, Point low, Point high) {
  const double x = std::max({low[0] - point[0], 0.0, point[0] - high[0]});
  const double y = std::max({low[1] - point[1], 0.0, point[1] - high[1]});
  return std::sqrt(x * x + y * y);
}

}  // namespace

double distance_to_segment(Point point, Point begin, Point end) {
  const double tx = end[0] - begin[0], ty = end[1] - begin[1];
  const double px = point[0] - begin[0], py = point[1] - begin[1];
  const double squared_length = tx * tx + ty * ty;
  const double along = squared_length > 0 ? std::clamp((px * tx + py * ty) / squared_length, 0.0, 1.0) : 0.0;
  const double x = px - along * tx, y = py - along * ty;
  return std::sqrt(x * x + y * y);
}

SegmentTree::SegmentTree(std::vector<WeightedSegment> segments) : segments_(std::move(segments)) {
  order_.resize(segments_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (!segments_.empty()) build(0, static_cast<std::uint32_t>(segments_.size()));
}

std::uint32_t SegmentTree::build(std::uint32_t first, std::uint32_t last) {
  Box box;
  box.low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  box.high = {-box.low[0], -box.low[1]};
  box.offset = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = first; i < last; ++i) {
    const WeightedSegment& segment = segments_[order_[i]];
    for (const Point& point : {segment.begin, segment.end})
      for (int k : {0, 1}) {
        box.low[k] = std::min(box.low[k], point[k]);
        box.high[k] = std::max(box.high[k], point[k]);
      }
    box.offset = std::min(box.offset, segment.offset);
  }
  const auto index = static_cast<std::uint32_t>(boxes_.size());
  boxes_.push_back(box);
  if (last - first <= leaf_size) {
    boxes_[index].leaf = true;
    boxes_[index].first = first;
    boxes_[index].last = last;
    return index;
  }
  const int axis = box.high[0] - box.low[0] >= box.high[1] - box.low[1] ? 0 : 1;
  const std::uint32_t middle = first + (last - first) / 2;
  const auto centre = [&](std::uint32_t s) { return segments_[s].begin[axis] + segments_[s].end[axis]; };
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return centre(a) != centre(b) ? centre(a) < centre(b) : a < b;
                   });
  const std::uint32_t left = build(first, middle);
  const std::uint32_t right = build(middle, last);
  boxes_[index].first = left;
  boxes_[index].last = right;
  return index;
}

double SegmentTree::distance_to(std::uint32_t segment, Point point) const {
  const WeightedSegment& s = segments_[segment];
  return s.offset + distance_to_segment(point, s.begin, s.end);
}

SegmentTree::Nearest SegmentTree::nearest(Point point) const {
  Nearest best{0, std::numeric_limits<double>::infinity()};
  if (boxes_.empty()) return best;
  struct Entry {
    std::uint32_t box;
    double bound;
  };
  const auto bound = [&](std::uint32_t box) {
    return boxes_[box].offset + distance_to_box(point, boxes_[box].low, boxes_[box].high);
  };
  std::array<Entry, stack_size> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, bound(0)};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.bound > best.distance) continue;
    const Box& box = boxes_[entry.box];
    if (box.leaf) {
      for (std::uint32_t i = box.first; i < box.last; ++i) {
        const double distance = distance_to(order_[i], point);
        if (distance < best.distance || (distance == best.distance && order_[i] < best.segment))
          best = {order_[i], distance};
      }
      continue;
    }
    const Entry first{box.first, bound(box.first)}, last{box.last, bound(box.last)};
    const bool first_is_nearer = first.bound <= last.bound;
    stack[depth++] = first_is_nearer ? last : first;
    stack[depth++] = first_is_nearer ? first : last;
  }
  return best;
}

std::vector<std::uint32_t> SegmentTree::within(Point point, double distance) const {
  std::vector<std::uint32_t> found, stack;
  if (!boxes_.empty()) stack.push_back(0);
  while (!stack.empty()) {
    const Box& box = boxes_[stack.back()];
    stack.pop_back();
    if (box.offset + distance_to_box(point, box.low, box.high) > distance) continue;
    if (!box.leaf) {
      stack.push_back(box.first);
      stack.push_back(box.last);
      continue;
    }
    for (std::uint32_t i = box.first; i < box.last; ++i)
      if (distance_to(order_[i], point) <= distance) found.push_back(order_[i]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace fissura::structure
