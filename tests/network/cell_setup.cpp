// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/network/cell_setup.hpp"

namespace fissura::network::test {

FlowCase water() {
  return {.hash = "water",
          .thickness = 10,
          .fluids = {{.name = "water", .consistency_index = 1.67e-3, .power_index = 1, .bulk_modulus = 2e9}},
          .well_index = 1e-5,
          .minimum_aperture = 1e-5,
          .tolerance = 1e-10,
          .maximum_iterations = 100,
          .stages = {}};
}

PumpingStage from_the_start(WellControl control, double target) {
  return {.begin = 0, .control = control, .target = target, .ramp = 0, .fluid = 0};
}

Insertion chain(std::size_t nodes, double h, const std::vector<std::size_t>& perforations) {
  Insertion first;
  for (std::size_t i = 0; i < nodes; ++i) {
    const bool at_end = i == 0 || i + 1 == nodes;
    first.new_nodes.push_back({.id = i + 1,
                               .x = h * static_cast<double>(i),
                               .lumped_length = at_end ? h / 2 : h,
                               .role = at_end ? NodeRole::tip : NodeRole::interior});
    if (i > 0) first.new_segments.push_back({.id = i, .node_a = i, .node_b = i + 1, .length = h});
  }
  for (const std::size_t i : perforations) first.new_perforations.push_back({"well", i + 1});
  return first;
}

CellSetup::CellSetup(FlowSolver& solver, const FlowCase& flow_case, const Insertion& first)
    : solver_(solver) {
  solver_.join(flow_case);
  insert(first);
}

void CellSetup::insert(const Insertion& insertion) {
  network.apply(insertion);
  solver_.insert(insertion, network);
  const std::size_t count = network.nodes().size();
  interval.aperture.resize(count);
  interval.aperture_rate.resize(count);
  interval.reference_pressure.resize(count);
  interval.compliance.resize(count);
  interval.closed.resize(count);
}

FlowAnswer CellSetup::advance(double duration) {
  interval.begin = interval.end;
  interval.end += duration;
  return solver_.advance(interval);
}

std::vector<double> CellSetup::content() const {
  return solver_.neutral_state().content;
}

}  // namespace fissura::network::test
