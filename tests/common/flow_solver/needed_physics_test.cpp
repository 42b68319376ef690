// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/case/case_json.hpp"
#include "common/flow_solver/flow_solver.hpp"

using namespace fissura;

namespace {

/// Water at a constant rate.
Case plain_case() {
  Case value;
  value.domain = {100, 100, 1};
  value.fluids = {{"water", 1e-3, 1, 2e9}, {"gel", 0.5, 0.5, 2e9}};
  value.injection.well_index = 1e-5;
  value.injection.stages = {{.begin = 0, .rate = 1e-3, .fluid = "water"}};
  return value;
}

std::set<std::string> needed(const Case& value) {
  return needed_physics(case_to_json(value));
}

}  // namespace

TEST_CASE("a case asks a solver for what its fluids, stages and fractures need, and for nothing else",
          "[flow_solver]") {
  CHECK(needed(plain_case()).empty());
  Case value = plain_case();
  value.leak_off.spurt_volume = 1e-6;
  CHECK(needed(value) == std::set<std::string>{claims::leak_off});
  value = plain_case();
  value.injection.stages.push_back({.begin = 5, .rate = 1e-3, .fluid = "gel"});
  CHECK(needed(value) == std::set<std::string>{claims::power_law, claims::several_fluids});
  value = plain_case();
  value.injection.stages.front().control = StageControl::pressure;
  CHECK(needed(value) == std::set<std::string>{claims::pressure_control});
  value = plain_case();
  value.fractures.emplace_back().kind = FractureKind::natural;
  CHECK(needed(value) == std::set<std::string>{claims::natural_fractures});
  value = plain_case();
  value.coupling.scheme = CouplingScheme::profit2016;
  CHECK(needed(value) == std::set<std::string>{claims::carry_pressure});
}
