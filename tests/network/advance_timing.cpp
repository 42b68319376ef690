// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>

#include "tests/network/flow_setup.hpp"

using namespace fissura::network;
using namespace fissura::network::test;

namespace {

/// Microseconds of one coupling interval of a growing-fracture-like load: wet, leaking, pumped in the middle.
void time_advance(std::size_t nodes, Model model, const char* name) {
  model.schedule = constant_rate(1e-3);
  FlowSetup setup(std::move(model), straight_fracture(nodes, 0.25, {nodes / 2}));
  setup.set_rigid(5e-4);
  setup.interval.compliance.assign(nodes, 1e-10);
  setup.interval.reference_pressure.assign(nodes, 5e6);
  constexpr int intervals = 2000;
  long iterations = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < intervals; ++k) {
    iterations += setup.advance(1e-3).newton.iterations;
    for (std::size_t i = 0; i < nodes; ++i) {
      setup.interval.aperture[i] =
          hydraulic_aperture(setup.workspace.step.storage[i], setup.state.pressure[i]);
      setup.interval.reference_pressure[i] = setup.state.pressure[i];
    }
  }
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
  fmt::print("{:<12} {:>5} nodes {:>8.1f} microseconds per interval {:>6.2f} Newton iterations\n", name,
             nodes, spent.count() / intervals, static_cast<double>(iterations) / intervals);
}

}  // namespace

int main() {
  Model leaking = water_model(), power_law = water_model();
  leaking.leak_off = {1e-5, 0};
  power_law.fluids.front().law = {0.5, 0.5};
  for (const std::size_t nodes : {10, 30, 100, 300}) {
    time_advance(nodes, water_model(), "Newtonian");
    time_advance(nodes, leaking, "leak-off");
    time_advance(nodes, power_law, "power law");
  }
}
