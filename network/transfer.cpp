// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/transfer.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace fissura::network {

namespace {

std::size_t first_fluid(const Model& model) {
  for (const PumpingStage& stage : model.schedule.stages())
    if (stage.fluid) return *stage.fluid;
  return 0;
}

void add_nodes(const Model& model, const Graph& graph, std::size_t old_count, State& state) {
  const std::size_t count = graph.node_count(), fluids = model.fluids.size();
  for (auto* values : {&state.content, &state.pressure, &state.filled, &state.leaked, &state.waived,
                       &state.pore_content, &state.arrived})
    values->resize(count, 0.0);
  state.has_been_filled.resize(count, 0);
  for (std::size_t i = old_count; i < count; ++i) {
    const NetworkNode& node = graph.network().nodes()[i];
    state.joining.push_back(node.saturated ? 1 : 0);
    state.contact_pressure.push_back(node.formation_pressure);
  }
  state.exposure.resize(count);
  state.fluid_fraction.resize(count * fluids, 0.0);
  if (model.dry) return;
  for (std::size_t i = old_count; i < count; ++i) state.fluid_fraction[i * fluids + first_fluid(model)] = 1;
}

void inherit_fluids(const Model& model, const Insertion& insertion, const Graph& graph, State& state) {
  const std::size_t fluids = model.fluids.size();
  for (const NodeParent& pair : insertion.parents) {
    if (state.joining[graph.network().index_of(pair.node)]) continue;
    const auto from = state.fluid_fraction.begin() +
                      static_cast<std::ptrdiff_t>(graph.network().index_of(pair.parent) * fluids);
    const auto to = static_cast<std::ptrdiff_t>(graph.network().index_of(pair.node) * fluids);
    std::copy_n(from, fluids, state.fluid_fraction.begin() + to);
  }
}

/// Segments keep their flux by id; new ones are at rest.
void map_segments(const std::vector<SegmentId>& old_ids, const Graph& graph, State& state) {
  std::unordered_map<SegmentId, std::size_t> old_index;
  for (std::size_t s = 0; s < old_ids.size(); ++s) old_index.emplace(old_ids[s], s);
  std::vector<double> flux, gradient;
  for (const NetworkSegment& segment : graph.network().segments()) {
    const auto found = old_index.find(segment.id);
    flux.push_back(found == old_index.end() ? 0 : state.flux[found->second]);
    gradient.push_back(found == old_index.end() ? 0 : state.gradient[found->second]);
  }
  state.flux = std::move(flux);
  state.gradient = std::move(gradient);
}

/// New nodes next to `node`, each once.
std::vector<std::size_t> new_neighbours(const Graph& graph, std::size_t node, std::size_t old_count) {
  std::vector<std::size_t> found;
  for (const std::size_t segment : graph.segments_at(node))
    if (graph.across(segment, node) >= old_count) found.push_back(graph.across(segment, node));
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// What stands on a node, moved from its old length to its new one.
void rescale(const Graph& graph, std::size_t node, double old_length,
             const std::vector<std::size_t>& receivers, std::vector<double>& values) {
  const std::vector<double>& length = graph.lumped_length();
  if (length[node] >= old_length || receivers.empty()) {
    values[node] *= old_length / length[node];
    return;
  }
  double receiving = 0;
  for (const std::size_t receiver : receivers) receiving += length[receiver];
  for (const std::size_t receiver : receivers)
    values[receiver] += values[node] * (old_length - length[node]) / receiving;
}

void expose_new_nodes(const Insertion& insertion, const Graph& graph, std::size_t old_count, State& state) {
  std::vector<std::size_t> released;
  for (std::size_t i = old_count; i < graph.node_count(); ++i) {
    const double time = graph.network().nodes()[i].exposure_time;
    state.exposure[i] = {.begin = time, .end = time, .residence = 0, .front = Front::passed};
    if (graph.natural(i) || state.joining[i])
      state.exposure[i].front = Front::ahead;
    else if (insertion.revision > 0)
      released.push_back(i);
  }
  std::stable_sort(released.begin(), released.end(), [&](std::size_t i, std::size_t j) {
    return state.exposure[i].begin < state.exposure[j].begin;
  });
  for (const std::size_t i : released) expose(graph, i, state.exposure[i].begin, state.exposure);
  for (std::size_t i = 0; i < graph.node_count(); ++i)
    if (!graph.natural(i) && state.exposure[i].front == Front::inside &&
        graph.network().nodes()[i].role != NodeRole::tip)
      end_sweep(i, state.time, state.exposure);
}

}  // namespace

void insert_and_transfer(const Model& model, const Insertion& insertion, Graph& graph, State& state) {
  const std::size_t old_count = graph.node_count();
  const std::vector<double> old_length = graph.lumped_length();
  std::vector<SegmentId> old_segments;
  for (const NetworkSegment& segment : graph.network().segments()) old_segments.push_back(segment.id);

  graph.insert(insertion);
  add_nodes(model, graph, old_count, state);
  inherit_fluids(model, insertion, graph, state);
  map_segments(old_segments, graph, state);
  for (std::size_t i = 0; i < old_count; ++i) {
    if (graph.lumped_length()[i] == old_length[i]) continue;
    const std::vector<std::size_t> receivers = new_neighbours(graph, i, old_count);
    for (auto* values : {&state.content, &state.leaked, &state.waived, &state.pore_content, &state.arrived})
      rescale(graph, i, old_length[i], receivers, *values);
  }
  expose_new_nodes(insertion, graph, old_count, state);
  state.perforation_rate.resize(graph.perforations().size(), 0.0);
}

}  // namespace fissura::network
