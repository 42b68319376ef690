// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/coupling_law.hpp"

#include <catch2/catch.hpp>

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr double bulk_modulus = 2e9;

/// Three nodes: open and filled, open and partly filled, closed.
StructureResponse some_structure() {
  StructureResponse structure;
  structure.aperture = {2e-3, 1e-3, 0};
  structure.aperture_rate = {1e-4, 2e-4, 0};
  structure.pressure_applied = {6e6, 0, 1e6};
  structure.pressure_opening = {-3e6, -3e6, 8e6};
  structure.closed = {0, 0, 1};
  structure.broken = {1, 1, 0};
  return structure;
}

NetworkAnswer some_answer() {
  NetworkAnswer answer;
  answer.pressure = {7e6, 0, 9e6};
  answer.aperture_predicted = {2.1e-3, 1e-3, 1e-4};
  answer.filled = {1, 0.8, 1};
  return answer;
}

const std::vector<double> compliance{1e-9, 8e-10, 6e-11};

}  // namespace

TEST_CASE("the compliance acts beyond the pressure the open faces carry", "[coupler][scheme]") {
  const StructureEstimate estimate = robin_estimate(some_structure(), compliance);
  CHECK(estimate.reference_pressure[0] == 6e6);
  CHECK(estimate.reference_pressure[1] == 0);
}

TEST_CASE("closed faces open only beyond the pressure that would part them", "[coupler][scheme]") {
  StructureResponse structure = some_structure();
  CHECK(robin_estimate(structure, compliance).reference_pressure[2] == 8e6);
  structure.pressure_applied[2] = 8.5e6;
  CHECK(robin_estimate(structure, compliance).reference_pressure[2] == 8.5e6);
}

TEST_CASE("robin gives the network apertures as they are, no rate, and lets it carry its content",
          "[coupler][scheme]") {
  const StructureEstimate estimate = robin_estimate(some_structure(), compliance);
  CHECK(estimate.aperture == some_structure().aperture);
  CHECK(estimate.aperture_rate == std::vector<double>(3, 0));
  CHECK(estimate.compliance == compliance);
  CHECK(estimate.closed == some_structure().closed);
  CHECK(std::string(estimate.carry) == "content");
}

TEST_CASE("k_s is 1 / (C_R + e^/K_f) at filled nodes, so that k_s C_R never exceeds 1, and 0 elsewhere",
          "[coupler][scheme]") {
  const std::vector<PressureRamp> ramps =
      robin_ramps(some_structure(), some_answer(), compliance, bulk_modulus);
  REQUIRE(ramps.size() == 3);
  CHECK(ramps[0].stiffness == Approx(1 / (1e-9 + 2.1e-3 / 2e9)).epsilon(1e-14));
  CHECK(ramps[1].stiffness == 0);
  for (std::size_t i : {0u, 2u}) {
    CHECK(ramps[i].stiffness > 0);
    CHECK(ramps[i].stiffness * compliance[i] <= 1);
  }
}

TEST_CASE("a ramp leads from what the structure carries and has to what the network found",
          "[coupler][scheme]") {
  const PressureRamp ramp = robin_ramps(some_structure(), some_answer(), compliance, bulk_modulus)[0];
  CHECK(ramp.applied(0, 2e-3) == 6e6);
  CHECK(ramp.applied(1, 2.1e-3) == 7e6);
}

TEST_CASE("profit2016 takes 1/K_n for the compliance, the last rate, and carries the pressure",
          "[coupler][scheme]") {
  const std::vector<double> pressure{6.5e6, 0, 1e6}, rate{3e-4, 0, 0};
  const StructureEstimate estimate = profit_estimate(some_structure(), pressure, rate, 1e10);
  CHECK(estimate.compliance == std::vector<double>(3, 1e-10));
  CHECK(estimate.aperture_rate == rate);
  CHECK(estimate.reference_pressure == pressure);
  CHECK(estimate.closed == std::vector<double>(3, 0));
  CHECK(std::string(estimate.carry) == "pressure");
  CHECK(profit_estimate(some_structure(), pressure, rate, 0).compliance == std::vector<double>(3, 0));
}

TEST_CASE("profit2016 stiffens with 1 / (1/K_n + e/K_f), about the aperture at the beginning",
          "[coupler][scheme]") {
  const std::vector<PressureRamp> ramps =
      profit_ramps(some_structure(), some_answer(), 1e10, bulk_modulus, 1e-5);
  CHECK(ramps[0].stiffness == Approx(1 / (1e-10 + 2e-3 / 2e9)).epsilon(1e-14));
  CHECK(ramps[1].stiffness == 0);
  CHECK(ramps[2].stiffness == Approx(1 / (1e-10 + 1e-5 / 2e9)).epsilon(1e-14));
  CHECK(ramps[0].reference_aperture(1) == 2e-3);
}

TEST_CASE("the network learns the aperture of each arm as the structure measured it, if the structure tells",
          "[coupler][scheme]") {
  StructureResponse structure = some_structure();
  const ClockInterval interval{1, 0, 0.1};
  CHECK_FALSE(advance_network(interval, 0, robin_estimate(structure, compliance)).has("arm_aperture_a"));
  structure.arm_aperture_a = {2e-3, 1e-3};
  structure.arm_aperture_b = {1e-3, 5e-5};
  for (const StructureEstimate& estimate :
       {robin_estimate(structure, compliance), profit_estimate(structure, {0, 0, 0}, {0, 0, 0}, 1e10)}) {
    const Message command = advance_network(interval, 0, estimate);
    CHECK(command.numbers("arm_aperture_a") == structure.arm_aperture_a);
    CHECK(command.numbers("arm_aperture_b") == structure.arm_aperture_b);
  }
}
