// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupler/conformance/balance.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/physics_checks.hpp"
#include "coupler/conformance/still_rock.hpp"
#include "coupler/conformance/topologies.hpp"

// Flow that changes with time: c dp/dt = d/dx (e^3 / (12 mu) dp/dx), c = C_R + e / K_f.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3";
constexpr double pi = 3.14159265358979323846;
constexpr double rate = 2e-4;
constexpr StillRock soft{.aperture = 1e-4, .compliance = 1e-9};

/// A wave of half a length in a closed slit dies away like exp(-lambda t); of the segments and lumped lengths
/// lambda is 2 T / (l c) (1 - cos(pi / (n - 1))), exactly. A wave is made by references that differ: the
/// content is the aperture, everywhere the same.
std::string decay(const Candidate& candidate, std::size_t nodes) {
  constexpr double slit = 4, mean = 1e6, amplitude = 1e5;
  const double spacing = slit / static_cast<double>(nodes - 1), cells = static_cast<double>(nodes - 1);
  StillScene scene(candidate, water_case(0), straight_slit(nodes, spacing, nodes / 2), soft);
  for (std::size_t i = 0; i < nodes; ++i)
    scene.asked.reference_pressure[i] = mean + amplitude * std::cos(pi * static_cast<double>(i) / cells);
  const double conductance = std::pow(soft.aperture, 3) / (12 * water::viscosity * spacing);
  const double stored = soft.compliance + soft.aperture / water::bulk_modulus;
  const double lambda = 2 * conductance / (spacing * stored) * (1 - std::cos(pi / cells));
  // Two hundred intervals until the wave has half its height: a first order scheme that takes one step in
  // each is off by ln(2)^2 / 400, about 0.0012 of it; the bound leaves four times that.
  constexpr int intervals = 200;
  constexpr double tolerance = 0.005;
  const auto wave = [&](const std::vector<double>& pressure) {
    return (pressure.front() - pressure.back()) / 2;
  };
  scene.advance_many(intervals, std::log(2.0) / lambda / intervals);
  require_ratio("height of the wave when it should be half of it [Pa]", wave(scene.last.pressure),
                amplitude / 2, tolerance);
  // The wave keeps its form, a cosine about the mean.
  for (std::size_t i = 0; i < nodes; ++i)
    require_close(fmt::format("pressure of node {} [Pa]", i), scene.last.pressure[i],
                  mean + amplitude / 2 * std::cos(pi * static_cast<double>(i) / cells),
                  tolerance * amplitude);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.6g} Pa after {:.4g} s, {:.6g} Pa by hand", wave(scene.last.pressure), scene.time,
                     amplitude / 2);
}

std::string coarse(const Candidate& candidate) {
  return decay(candidate, 9);
}

std::string fine(const Candidate& candidate) {
  return decay(candidate, 21);
}

/// Pumping into the middle of a long slit: a source of constant strength in a line, whose pressure at the
/// source rises by Q / 2 sqrt(4 t / (pi S c)) with S = e^3 / (12 mu) (Carslaw and Jaeger, Conduction of Heat
/// in Solids, 2.9), until it reaches the ends.
std::string line_source(const Candidate& candidate) {
  constexpr std::size_t nodes = 81;
  constexpr double spacing = 0.1;
  // Nodes stand `spacing` apart and intervals follow each other: both are felt at the source, less the longer
  // it lasts. Measured at the end, when 400 cells' times have passed.
  constexpr double tolerance = 0.02;
  StillScene scene(candidate, water_case(rate), straight_slit(nodes, spacing, nodes / 2), soft);
  const double conductivity = std::pow(soft.aperture, 3) / (12 * water::viscosity);
  const double stored = soft.compliance + soft.aperture / water::bulk_modulus;
  const double slit = spacing * static_cast<double>(nodes - 1);
  // A quarter of the way to the ends is the depth sqrt(D t): what is felt there is below 1e-3 of the source.
  const double end = std::pow(slit / 2 / 5, 2) * stored / conductivity;
  scene.advance_many(200, end / 200);
  const double expected =
      rate / water::thickness / 2 * std::sqrt(4 * scene.time / (pi * conductivity * stored));
  require_ratio("pressure at the source [Pa]", scene.last.pressure[nodes / 2], expected, tolerance);
  require_within("pressure at the ends, by that at the source",
                 scene.last.pressure.front() / scene.last.pressure[nodes / 2], 0, 1e-3);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.6g} Pa, {:.6g} Pa by hand", scene.last.pressure[nodes / 2], expected);
}

/// Rounding may tell east from west, and whatever an iteration leaves.
constexpr double alike = 1e-8;

std::string symmetry(const Candidate& candidate) {
  constexpr std::size_t nodes = 11;
  StillScene scene(candidate, water_case(rate), straight_slit(nodes, 0.5, nodes / 2), soft);
  for (std::size_t i = 0; i < nodes; ++i)
    scene.asked.aperture[i] *= 1 - 0.1 * std::abs(static_cast<double>(i) - static_cast<double>(nodes / 2));
  double difference = 0;
  for (int k = 0; k < 10; ++k) {
    scene.advance(0.1);
    for (std::size_t i = 0; i < nodes / 2; ++i) {
      const double west = scene.last.pressure[i], east = scene.last.pressure[nodes - 1 - i];
      require_close(fmt::format("pressure of node {}, as far east as node {} is west [Pa]", nodes - 1 - i, i),
                    east, west, alike * scene.last.pressure[nodes / 2]);
      require_close("its filled", scene.last.filled[nodes - 1 - i], scene.last.filled[i], alike);
      difference = std::max(difference, std::abs(east - west) / scene.last.pressure[nodes / 2]);
    }
  }
  return fmt::format("east and west differ by {:.1e} of the pressure at the well", difference);
}

/// The same slit told from the other end, in other ids, with segments turned about and in another order.
std::string order(const Candidate& candidate) {
  constexpr std::size_t nodes = 8, well = 2;
  const Insertion plain = straight_slit(nodes, 0.5, well);
  Insertion other = plain;
  std::reverse(other.new_nodes.begin(), other.new_nodes.end());
  std::rotate(other.new_segments.begin(), other.new_segments.begin() + 3, other.new_segments.end());
  const auto renamed = [](NodeId id) { return (id * 7919) % 10007; };  // both prime: no two ids become one
  for (NetworkNode& node : other.new_nodes) node.id = renamed(node.id);
  for (NetworkSegment& segment : other.new_segments) {
    segment.id = 900000 - segment.id;
    segment.node_a = renamed(segment.node_a);
    segment.node_b = renamed(segment.node_b);
    if (segment.id % 2 == 0) std::swap(segment.node_a, segment.node_b);
  }
  for (PerforationNode& perforation : other.new_perforations) perforation.node = renamed(perforation.node);

  StillScene one(candidate, water_case(rate), plain, soft), two(candidate, water_case(rate), other, soft);
  for (std::size_t i = 0; i < nodes; ++i)
    one.asked.aperture[i] = two.asked.aperture[nodes - 1 - i] =
        (1 + 0.1 * static_cast<double>(i)) * soft.aperture;
  double difference = 0;
  for (int k = 0; k < 5; ++k) {
    one.advance(0.1);
    two.advance(0.1);
    for (std::size_t i = 0; i < nodes; ++i) {
      require_close(fmt::format("pressure of node {}, told as node {} [Pa]", i, nodes - 1 - i),
                    two.last.pressure[nodes - 1 - i], one.last.pressure[i], alike * one.last.pressure[well]);
      difference = std::max(difference, std::abs(two.last.pressure[nodes - 1 - i] - one.last.pressure[i]));
    }
    require_close("well pressure [Pa]", two.last.well_pressure, one.last.well_pressure,
                  alike * one.last.well_pressure);
  }
  return fmt::format("pressures differ by {:.1e} Pa of {:.4g} Pa", difference, one.last.pressure[well]);
}

/// Nothing moves of itself.
std::string at_rest(const Candidate& candidate) {
  StillRock rock = soft;
  rock.reference_pressure = 1e6;
  StillScene scene(candidate, water_case(0), straight_slit(9, 0.5, 4), rock);
  scene.advance(1);
  const double pressure = scene.last.pressure.front();
  scene.advance_many(20, 1);
  for (std::size_t i = 0; i < scene.last.pressure.size(); ++i)
    require_ratio(fmt::format("pressure of node {} after 20 s [Pa]", i), scene.last.pressure[i], pressure,
                  solution_tolerance);
  require_ratio("pressure at rest [Pa]", pressure, rock.pressure_of(rock.aperture, water::bulk_modulus),
                solution_tolerance);
  require_balance(scene.driver, scene.last);
  return fmt::format("{:.9g} Pa everywhere, always", pressure);
}

}  // namespace

std::vector<Check> diffusion_checks() {
  const std::set<std::string> flow{claims::viscous_flow};
  return {
      {.name = "diffusion.coarse",
       .contract = contract,
       .expected = "a wave of pressure in a closed slit of nine nodes dies away in its time",
       .physics = flow,
       .carry_out = coarse},
      {.name = "diffusion.fine",
       .contract = contract,
       .expected = "the same of twenty-one nodes",
       .physics = flow,
       .carry_out = fine},
      {.name = "diffusion.line_source",
       .contract = contract,
       .expected = "pumped into the middle of a long slit, the pressure there grows like the root of time",
       .physics = flow,
       .carry_out = line_source},
      {.name = "diffusion.symmetry",
       .contract = contract,
       .expected = "what is alike in east and west is answered alike",
       .physics = flow,
       .carry_out = symmetry},
      {.name = "diffusion.order",
       .contract = "flow_solvers.md 5",
       .expected = "ids, directions of segments, and the order in which all are told change nothing",
       .physics = flow,
       .carry_out = order},
      {.name = "diffusion.at_rest",
       .contract = contract,
       .expected = "a slit under one pressure stays under it",
       .carry_out = at_rest},
  };
}

}  // namespace fissura::coupler::conformance
