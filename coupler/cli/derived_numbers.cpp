// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/derived_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupler/seismicity/analysis/frequency_magnitude.hpp"

namespace fissura::coupler {

namespace {

const Fluid* fluid_named(const Case& run_case, const std::string& name) {
  for (const Fluid& fluid : run_case.fluids)
    if (fluid.name == name) return &fluid;
  return nullptr;
}

double compression_wave(const Rock& rock) {
  const double nu = rock.poissons_ratio;
  return std::sqrt(rock.youngs_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu) * rock.density));
}

std::string regime(double toughness) {
  if (toughness < 1) return "viscosity dominates";
  return toughness > 4 ? "toughness dominates" : "between viscosity and toughness";
}

double edge_at_the_tips(const Case& run_case) {
  return run_case.growth.path == PathRule::free ? run_case.mesh.tip_size : run_case.mesh.fracture_size;
}

/// Smallest step that a regular triangle of edge h allows, at physical density [s].
double step_of_regular_triangle(const Case& run_case) {
  const double altitude = std::sqrt(3.0) / 2 * edge_at_the_tips(run_case);
  return run_case.dynamics.safety_factor * altitude / compression_wave(run_case.rock) /
         std::sqrt(1 + run_case.dynamics.damping);
}

}  // namespace

std::vector<DerivedNumber> derived_numbers(const Case& run_case) {
  const Rock& rock = run_case.rock;
  const double modulus = rock.plane_strain_modulus(), h = edge_at_the_tips(run_case);
  std::vector<DerivedNumber> numbers;
  numbers.push_back({"plane-strain modulus", modulus, "Pa", ""});
  const double toughness = std::sqrt(modulus * rock.fracture_energy);
  numbers.push_back({"fracture toughness", toughness, "Pa m^0.5", "sqrt(E' G_f)"});
  const double zone = modulus * rock.fracture_energy / (rock.tensile_strength * rock.tensile_strength);
  numbers.push_back({"cohesive length", zone, "m",
                     h > 0.3 * zone
                         ? "longer elements than 0.3 of it: near the toughness end lengths come out short"
                         : "elements are short enough"});
  for (const Stage& stage : run_case.injection.stages) {
    const Fluid* fluid = fluid_named(run_case, stage.fluid);
    if (stage.control != StageControl::rate || fluid == nullptr || fluid->power_index != 1) continue;
    const double rate = stage.rate / run_case.domain.thickness;
    const double k = std::sqrt(32 / std::numbers::pi) * toughness;
    const double km =
        std::pow(std::pow(k, 4) / (12 * fluid->consistency_index * rate * std::pow(modulus, 3)), 0.25);
    numbers.push_back({"dimensionless toughness", km, "1", regime(km)});
  }
  numbers.push_back({"compression wave speed", compression_wave(rock), "m/s", ""});
  const double step = step_of_regular_triangle(run_case);
  numbers.push_back(
      {"explicit step at physical density", step, "s", "of a regular element; the mesh decides"});
  const double first = step * std::sqrt(run_case.dynamics.initial_mass_scale);
  numbers.push_back({"explicit step at the start", first, "s", "with the initial mass scale"});
  numbers.push_back({"explicit steps at most", run_case.time.end / first, "1", "mass scaling lowers it"});
  numbers.push_back(
      {"coupling intervals at most", run_case.time.end / first / run_case.coupling.minimum_steps, "1", ""});
  numbers.push_back({"field reports", std::floor(run_case.time.end / run_case.output.interval), "1", ""});
  numbers.push_back({"magnitude of an element that opens fully", numerical_magnitude_floor(run_case), "1",
                     "at the tips; smaller events show the mesh"});
  return numbers;
}

}  // namespace fissura::coupler
