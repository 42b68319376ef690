// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/coupling/trace_lines.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace fissura {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr double greatest_turn_cosine = 0.5;

struct Ends {
  std::size_t a = 0, b = 0;
};

class LineWalk {
 public:
  explicit LineWalk(const FractureNetwork& network) : network_(network), arms_(network.nodes().size()) {
    for (std::size_t s = 0; s < network.segments().size(); ++s) {
      const NetworkSegment& segment = network.segments()[s];
      ends_.push_back({network.index_of(segment.node_a), network.index_of(segment.node_b)});
      arms_[ends_[s].a].push_back(s);
      arms_[ends_[s].b].push_back(s);
    }
    next_at_a_.assign(ends_.size(), none);
    next_at_b_.assign(ends_.size(), none);
    for (std::size_t node = 0; node < arms_.size(); ++node) pair_arms(node);
  }

  std::vector<TraceLine> lines() {
    std::vector<bool> taken(ends_.size(), false);
    std::vector<TraceLine> found;
    for (std::size_t s = 0; s < ends_.size(); ++s)
      if (!taken[s]) found.push_back(walk(s, taken));
    return found;
  }

 private:
  [[nodiscard]] std::size_t across(std::size_t segment, std::size_t node) const {
    return ends_[segment].a == node ? ends_[segment].b : ends_[segment].a;
  }

  std::size_t& next_at(std::size_t segment, std::size_t node) {
    return ends_[segment].a == node ? next_at_a_[segment] : next_at_b_[segment];
  }

  /// 1 where the trace goes straight on from one segment to the other.
  [[nodiscard]] double turn_cosine(std::size_t node, std::size_t one, std::size_t other) const {
    const auto& nodes = network_.nodes();
    const NetworkNode &here = nodes[node], &from = nodes[across(one, node)], &to = nodes[across(other, node)];
    const double product = (here.x - from.x) * (to.x - here.x) + (here.y - from.y) * (to.y - here.y);
    return product / (network_.segments()[one].length * network_.segments()[other].length);
  }

  void pair_arms(std::size_t node) {
    const std::vector<std::size_t>& arms = arms_[node];
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < arms.size(); ++i)
      for (std::size_t j = i + 1; j < arms.size(); ++j) {
        const double cosine = turn_cosine(node, arms[i], arms[j]);
        if (arms.size() == 2 || cosine > greatest_turn_cosine) pairs.emplace_back(-cosine, arms[i], arms[j]);
      }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [turn, one, other] : pairs) {
      if (next_at(one, node) != none || next_at(other, node) != none) continue;
      next_at(one, node) = other;
      next_at(other, node) = one;
    }
  }

  TraceLine walk(std::size_t first, std::vector<bool>& taken) {
    std::size_t segment = first, node = ends_[first].a;
    for (std::size_t before = next_at(segment, node); before != none && before != first;
         before = next_at(segment, node)) {
      segment = before;
      node = across(segment, node);
    }
    TraceLine line;
    line.nodes.push_back(node);
    while (segment != none && !taken[segment]) {
      taken[segment] = true;
      node = across(segment, node);
      line.nodes.push_back(node);
      line.segments.push_back(segment);
      line.length += network_.segments()[segment].length;
      segment = next_at(segment, node);
    }
    return line;
  }

  const FractureNetwork& network_;
  std::vector<Ends> ends_;
  std::vector<std::vector<std::size_t>> arms_;
  std::vector<std::size_t> next_at_a_, next_at_b_;
};

}  // namespace

std::vector<TraceLine> trace_lines(const FractureNetwork& network) {
  return LineWalk(network).lines();
}

}  // namespace fissura
