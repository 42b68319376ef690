// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/flow.hpp"

#include <cmath>
#include <numeric>

namespace fissura::network {

namespace {

void share_rate(double rate, std::vector<double>& shares) {
  if (shares.empty()) return;
  if (shares.size() == 1) shares.front() = rate;
  // WI p_w is many orders larger than its difference to WI p; what rounding took away is returned evenly.
  for (int round = 0; round < 2; ++round) {
    const double missing = rate - std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double& share : shares) share += missing / static_cast<double>(shares.size());
  }
}

}  // namespace

void flow_of(const Model& model, const Graph& graph, const Step& step, const Assembly& solution, Flow& flow) {
  const std::vector<NetworkSegment>& segments = graph.network().segments();
  flow.inflow.assign(graph.node_count(), 0.0);
  flow.flux.resize(segments.size());
  flow.gradient.resize(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto [a, b] = graph.ends()[s];
    const double drop = solution.pressure[a] - solution.pressure[b];
    const double flux = step.transmissibility[s] * drop;
    flow.flux[s] = flux;
    flow.gradient[s] = std::abs(drop) / segments[s].length;
    flow.inflow[a] -= flux;
    flow.inflow[b] += flux;
  }
  const std::vector<std::size_t>& perforations = graph.perforations();
  flow.perforation_rate.resize(perforations.size());
  for (std::size_t k = 0; k < perforations.size(); ++k)
    flow.perforation_rate[k] =
        model.well_index * (solution.well_pressure - solution.pressure[perforations[k]]);
  if (step.well.control == WellControl::rate) share_rate(step.well.value, flow.perforation_rate);
  for (std::size_t k = 0; k < perforations.size(); ++k)
    flow.inflow[perforations[k]] += flow.perforation_rate[k];
}

}  // namespace fissura::network
