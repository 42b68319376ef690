// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/network/flow_setup.hpp"

#include <string>
#include <utility>

namespace fissura::network::test {

Model water_model() {
  Model model;
  model.fluids.push_back({"water", {1.67e-3, 1}, 2e9});
  model.well_index = 1e-5;
  model.thickness = 1;
  model.minimum_aperture = 1e-5;
  model.tolerance = 1e-10;
  model.maximum_iterations = 100;
  return model;
}

Schedule constant_rate(double rate) {
  return Schedule({{.begin = 0, .control = WellControl::rate, .target = rate, .ramp = 0, .fluid = 0}});
}

Schedule constant_pressure(double pressure) {
  return Schedule(
      {{.begin = 0, .control = WellControl::pressure, .target = pressure, .ramp = 0, .fluid = 0}});
}

Insertion straight_fracture(std::size_t nodes, double h, const std::vector<std::size_t>& perforations,
                            SegmentKind kind) {
  Insertion insertion;
  for (std::size_t i = 0; i < nodes; ++i) {
    const bool at_end = i == 0 || i + 1 == nodes;
    insertion.new_nodes.push_back({.id = i + 1,
                                   .x = static_cast<double>(i) * h,
                                   .y = 0,
                                   .lumped_length = at_end ? 0.5 * h : h,
                                   .fracture = 1,
                                   .role = at_end ? NodeRole::tip : NodeRole::interior,
                                   .exposure_time = 0});
    if (i > 0)
      insertion.new_segments.push_back(
          {.id = i, .node_a = i, .node_b = i + 1, .fracture = 1, .kind = kind, .length = h});
  }
  for (const std::size_t node : perforations)
    insertion.new_perforations.push_back({"perforation " + std::to_string(node), node + 1});
  return insertion;
}

FlowSetup::FlowSetup(Model the_model, const Insertion& first) : model(std::move(the_model)) {
  insert(first);
}

void FlowSetup::insert(const Insertion& insertion) {
  insert_and_transfer(model, insertion, graph, state);
  workspace.linear.set_pattern(graph.pattern());
  for (auto* values :
       {&interval.aperture, &interval.aperture_rate, &interval.reference_pressure, &interval.compliance})
    values->resize(graph.node_count(), 0.0);
  interval.faces.resize(graph.node_count(), Faces::separated);
}

AdvanceReport FlowSetup::advance(double duration) {
  interval.begin = state.time;
  interval.end = state.time + duration;
  return network::advance(model, graph, interval, state, workspace);
}

void FlowSetup::set_rigid(double aperture) {
  interval.aperture.assign(graph.node_count(), aperture);
  interval.compliance.assign(graph.node_count(), 0.0);
}

double FlowSetup::stored() const {
  double sum = 0;
  for (std::size_t i = 0; i < graph.node_count(); ++i) sum += graph.lumped_length()[i] * state.content[i];
  return sum;
}

}  // namespace fissura::network::test
