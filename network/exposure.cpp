// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/exposure.hpp"

#include <algorithm>

namespace fissura::network {

double leak_off_demand(const CarterLaw& law, const Exposure& exposure, double time) {
  switch (exposure.front) {
    case Front::ahead:
      return 0;
    case Front::inside:
      return cell_leak_off(law, exposure.begin, std::max(time, exposure.begin + exposure.residence), time);
    case Front::passed:
      break;
  }
  return cell_leak_off(law, exposure.begin, exposure.end, time);
}

void expose(const Graph& graph, std::size_t node, double time, std::vector<Exposure>& exposures) {
  Exposure& cell = exposures[node];
  cell = {.begin = time, .end = time, .residence = 0, .front = Front::inside};
  for (const std::size_t segment : graph.segments_at(node)) {
    const std::size_t neighbour = graph.across(segment, node);
    Exposure& before = exposures[neighbour];
    if (before.front != Front::inside || before.begin >= time) continue;
    cell.residence = std::max(cell.residence, time - before.begin);
    end_sweep(neighbour, time, exposures);
  }
}

void end_sweep(std::size_t node, double time, std::vector<Exposure>& exposures) {
  Exposure& cell = exposures[node];
  cell.end = std::max(cell.begin, time);
  cell.front = Front::passed;
}

bool leads_ahead(const Graph& graph, std::size_t node, const std::vector<Exposure>& exposures) {
  const auto segments = graph.segments_at(node);
  return std::any_of(segments.begin(), segments.end(), [&](std::size_t segment) {
    return exposures[graph.across(segment, node)].front == Front::ahead;
  });
}

}  // namespace fissura::network
