// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/fluid_transport.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace fissura::network {

namespace {

class Sweep {
 public:
  Sweep(const Model& model, const Graph& graph, const Step& step, const Assembly& solution, const Flow& flow,
        State& state)
      : graph_(graph),
        flow_(flow),
        fraction_(state.fluid_fraction),
        fluids_(model.fluids.size()),
        well_(graph.node_count()),
        duration_(step.duration()),
        amount_((well_ + 1) * fluids_, 0.0),
        well_fraction_(fluids_, 0.0) {
    for (std::size_t i = 0; i < well_; ++i)
      for (std::size_t f = 0; f < fluids_; ++f)
        amount(i, f) =
            graph.lumped_length()[i] * std::max(0.0, state.content[i]) * fraction_[i * fluids_ + f];
    const double net = std::accumulate(flow.perforation_rate.begin(), flow.perforation_rate.end(), 0.0);
    if (state.stage && model.schedule.stages()[*state.stage].fluid)
      amount(well_, *model.schedule.stages()[*state.stage].fluid) += duration_ * std::max(0.0, net);
    order_by_pressure(solution);
  }

  void run() {
    for (const std::size_t place : order_) {
      mix(place);
      if (place == well_)
        leave_well();
      else
        leave_node(place);
    }
  }

 private:
  double& amount(std::size_t place, std::size_t fluid) { return amount_[place * fluids_ + fluid]; }

  std::span<double> fraction_at(std::size_t place) {
    if (place == well_) return well_fraction_;
    return std::span(fraction_).subspan(place * fluids_, fluids_);
  }

  void order_by_pressure(const Assembly& solution) {
    order_.resize(well_ + 1);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const auto pressure = [&](std::size_t i) {
      return i == well_ ? solution.well_pressure : solution.pressure[i];
    };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t i, std::size_t j) { return pressure(i) > pressure(j); });
  }

  void mix(std::size_t place) {
    double total = 0;
    for (std::size_t f = 0; f < fluids_; ++f) total += amount(place, f);
    if (total <= 0) return;
    const std::span<double> fraction = fraction_at(place);
    for (std::size_t f = 0; f < fluids_; ++f) fraction[f] = amount(place, f) / total;
  }

  void pass(std::size_t from, std::size_t to, double rate) {
    const std::span<const double> fraction = fraction_at(from);
    for (std::size_t f = 0; f < fluids_; ++f) amount(to, f) += duration_ * rate * fraction[f];
  }

  void leave_well() {
    for (std::size_t k = 0; k < flow_.perforation_rate.size(); ++k)
      if (flow_.perforation_rate[k] > 0) pass(well_, graph_.perforations()[k], flow_.perforation_rate[k]);
  }

  void leave_node(std::size_t node) {
    for (const std::size_t segment : graph_.segments_at(node)) {
      const double outward = graph_.ends()[segment].a == node ? flow_.flux[segment] : -flow_.flux[segment];
      if (outward > 0) pass(node, graph_.across(segment, node), outward);
    }
    for (std::size_t k = 0; k < flow_.perforation_rate.size(); ++k)
      if (graph_.perforations()[k] == node && flow_.perforation_rate[k] < 0)
        pass(node, well_, -flow_.perforation_rate[k]);
  }

  const Graph& graph_;
  const Flow& flow_;
  std::vector<double>& fraction_;
  std::size_t fluids_, well_;
  double duration_;
  std::vector<double> amount_, well_fraction_;
  std::vector<std::size_t> order_;
};

}  // namespace

void move_fluids(const Model& model, const Graph& graph, const Step& step, const Assembly& solution,
                 const Flow& flow, State& state) {
  if (model.single_fluid()) return;
  Sweep(model, graph, step, solution, flow, state).run();
}

}  // namespace fissura::network
