// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/wetting.hpp"

#include <algorithm>

namespace fissura::network {

namespace {

class FrontStep {
 public:
  FrontStep(const Graph& graph, const Flow& flow, double duration, const State& state)
      : graph_(graph), flow_(flow), duration_(duration), state_(state), passing_(graph.node_count(), 1.0) {
    for (std::size_t i = 0; i < graph.node_count(); ++i)
      if (state.exposure[i].front == Front::ahead) {
        ahead_.push_back(i);
        passing_[i] = 0;
      }
    injected_.assign(ahead_.empty() ? 0 : graph.node_count(), 0.0);
    for (std::size_t k = 0; k < graph.perforations().size() && !ahead_.empty(); ++k)
      injected_[graph.perforations()[k]] += std::max(0.0, flow.perforation_rate[k]);
  }

  /// The nodes that are wetted in this step, in the order in which the front reaches them.
  std::vector<std::size_t> wetted() {
    std::vector<std::size_t> nodes;
    for (bool further = true; further;) {
      further = false;
      for (const std::size_t i : ahead_) {
        if (passing_[i] > 0) continue;
        const double received = arriving(i), beyond = state_.arrived[i] + received - state_.pore_content[i];
        if (received <= 0 || beyond <= 0) continue;
        passing_[i] = std::min(1.0, beyond / inflow(i));
        nodes.push_back(i);
        further = true;
      }
    }
    return nodes;
  }

  [[nodiscard]] const std::vector<std::size_t>& ahead() const { return ahead_; }

  /// Injected fluid that comes in during the step [m].
  [[nodiscard]] double arriving(std::size_t node) const {
    double rate = injected_[node];
    for (const std::size_t segment : graph_.segments_at(node))
      rate += inward(segment, node) * passing_[graph_.across(segment, node)];
    return duration_ * rate / graph_.lumped_length()[node];
  }

 private:
  [[nodiscard]] double inward(std::size_t segment, std::size_t node) const {
    return std::max(0.0, graph_.ends()[segment].b == node ? flow_.flux[segment] : -flow_.flux[segment]);
  }

  /// Fluid of either kind that comes in during the step [m].
  [[nodiscard]] double inflow(std::size_t node) const {
    double rate = injected_[node];
    for (const std::size_t segment : graph_.segments_at(node)) rate += inward(segment, node);
    return duration_ * rate / graph_.lumped_length()[node];
  }

  const Graph& graph_;
  const Flow& flow_;
  double duration_;
  const State& state_;
  std::vector<double> passing_;  ///< share of injected fluid in what leaves a node
  std::vector<double> injected_;
  std::vector<std::size_t> ahead_;
};

}  // namespace

void advance_wetting_front(const Graph& graph, const Flow& flow, double duration, State& state) {
  FrontStep step(graph, flow, duration, state);
  if (step.ahead().empty()) return;
  const std::vector<std::size_t> nodes = step.wetted();
  for (const std::size_t i : step.ahead()) state.arrived[i] += step.arriving(i);
  wet_natural_fractures(graph, nodes, state.time, state.exposure);
}

void wet_natural_fractures(const Graph& graph, std::span<const std::size_t> nodes, double time,
                           std::vector<Exposure>& exposures) {
  for (const std::size_t i : nodes) expose(graph, i, time, exposures);
  for (const std::size_t i : nodes)
    if (!leads_ahead(graph, i, exposures)) end_sweep(i, time, exposures);
}

}  // namespace fissura::network
