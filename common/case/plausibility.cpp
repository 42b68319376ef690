// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/plausibility.hpp"
#include "common/case/slip_in_situ.hpp"

#include <cmath>

#include <fmt/format.h>

namespace fissura::input {

namespace {

struct Window {
  double lower, upper;
};

class Plausibility {
 public:
  explicit Plausibility(const SourceValue& document) : document_(document) {}

  void look_at(const std::string& key, double value, const char* unit, const Window& window) {
    if (value >= window.lower && value <= window.upper) return;
    warnings_.push_back(
        {position_of(document_, key), key, fmt::format("{:.6g} {}", value, unit),
         fmt::format("usually {:g} to {:g} {} (is the unit right?)", window.lower, window.upper, unit), ""});
  }

  /// The same for a value that may also be zero, with the window on its magnitude.
  void look_at_magnitude(const std::string& key, double value, const char* unit, const Window& window) {
    if (value != 0) look_at(key, std::abs(value), unit, window);
  }

  void warn(const std::string& key, const std::string& found, const std::string& expected) {
    warnings_.push_back({position_of(document_, key), key, found, expected, ""});
  }

  FaultList warnings() && { return std::move(warnings_); }

 private:
  const SourceValue& document_;
  FaultList warnings_;
};

void look_at_rock(const Case& value, Plausibility& plausibility) {
  plausibility.look_at("rock.density", value.rock.density, "kg/m3", {1000, 5000});
  plausibility.look_at("rock.youngs_modulus", value.rock.youngs_modulus, "Pa", {1e8, 3e11});
  plausibility.look_at("rock.poissons_ratio", value.rock.poissons_ratio, "", {0, 0.495});
  plausibility.look_at("rock.tensile_strength", value.rock.tensile_strength, "Pa", {1e3, 1e8});
  plausibility.look_at("rock.fracture_energy", value.rock.fracture_energy, "J/m2", {1e-3, 1e5});
  const char* const keys[]{"in_situ.maximum_horizontal_stress", "in_situ.minimum_horizontal_stress"};
  for (std::size_t i = 0; i < std::size(keys); ++i)
    plausibility.look_at_magnitude(keys[i], value.in_situ.stress[i], "Pa", {1e2, 5e8});
  plausibility.look_at_magnitude("in_situ.vertical_stress", value.in_situ.stress[3], "Pa", {1e2, 5e8});
  plausibility.look_at_magnitude("in_situ.pore_pressure", value.in_situ.pore_pressure, "Pa", {1e2, 3e8});
}

void look_at_fluid(const Case& value, Plausibility& plausibility) {
  for (std::size_t i = 0; i < value.fluids.size(); ++i) {
    const Fluid& fluid = value.fluids[i];
    const std::string key = fmt::format("fluid[{}].", i);
    const std::string rheology = fluid.power_index == 1 ? "viscosity" : "consistency_index";
    const char* const unit = fluid.power_index == 1 ? "Pa s" : "Pa s^n";
    plausibility.look_at(key + rheology, fluid.consistency_index, unit, {1e-6, 100});
    plausibility.look_at(key + "bulk_modulus", fluid.bulk_modulus, "Pa", {1e5, 1e11});
  }
  plausibility.look_at_magnitude("leak_off.coefficient", value.leak_off.coefficient, "m/s^0.5", {1e-8, 1e-2});
  plausibility.look_at_magnitude("leak_off.spurt_volume", value.leak_off.spurt_volume, "m", {1e-7, 1e-1});
}

void look_at_treatment(const Case& value, Plausibility& plausibility) {
  const Injection& injection = value.injection;
  for (std::size_t i = 0; i < injection.perforations.size(); ++i)
    plausibility.look_at(fmt::format("injection.perforation[{}].aperture", i),
                         injection.perforations[i].aperture, "m", {1e-8, 0.1});
  for (std::size_t i = 0; i < injection.stages.size(); ++i)
    plausibility.look_at_magnitude(fmt::format("injection.stage[{}].rate", i), injection.stages[i].rate,
                                   "m3/s", {1e-12, 10});
  if (!injection.perforations.empty())
    plausibility.look_at("injection.well_index", injection.well_index, "m2/(s Pa)", {1e-12, 1});
}

void look_at_controls(const Case& value, Plausibility& plausibility) {
  plausibility.look_at("time.end", value.time.end, "s", {1e-6, 1e7});
  plausibility.look_at("domain.width", value.domain.width, "m", {1e-2, 1e5});
  plausibility.look_at("domain.height", value.domain.height, "m", {1e-2, 1e5});
  plausibility.look_at("domain.thickness", value.domain.thickness, "m", {1e-3, 1e3});
  plausibility.look_at("network.minimum_aperture", value.network.minimum_aperture, "m", {1e-9, 1e-3});
  double length = 0;
  for (const FractureLine& line : value.fractures)
    for (std::size_t i = 1; i < line.points.size(); ++i)
      length +=
          std::hypot(line.points[i][0] - line.points[i - 1][0], line.points[i][1] - line.points[i - 1][1]);
  const double h = value.mesh.fracture_size;
  const double area_of_an_element = std::sqrt(3.0) / 4 * h * h;
  if (length == 0) return;
  plausibility.look_at("mesh.fracture_size", 2 * value.mesh.corridor * length / area_of_an_element,
                       "elements along the fractures", {1, 1e7});
}

void look_at_seismicity(const Case& value, Plausibility& plausibility) {
  const Seismicity& seismicity = value.seismicity;
  plausibility.look_at_magnitude("seismicity.slip_rate", seismicity.slip_rate, "m/s", {1e-9, 10});
  plausibility.look_at_magnitude("seismicity.failure_rate", seismicity.failure_rate, "m/s", {1e-9, 10});
  plausibility.look_at_magnitude("seismicity.stress_drop", seismicity.stress_drop, "Pa", {1, 1e8});
  plausibility.look_at_magnitude("seismicity.cluster_time", seismicity.cluster_time, "s", {1e-6, 1e4});
  plausibility.look_at_magnitude("seismicity.rest_time", seismicity.rest_time, "s", {1e-6, 1e4});
  plausibility.look_at("seismicity.voxel_size", seismicity.voxel_size, "m", {1e-3, 1e4});
  if (value.georeference)
    plausibility.look_at("georeference.depth", value.georeference->depth, "m", {-1e4, 1e5});
  const double radius = seismicity.cluster_radius, size = value.mesh.fracture_size;
  if (radius > 0 && radius < size)
    plausibility.warn("seismicity.cluster_radius", fmt::format("{:.6g} m", radius),
                      fmt::format("usually at least mesh.fracture_size, {:.6g} m: neighbours along a fracture "
                                  "never form one event",
                                  size));
}

void look_at_natural_fractures(const Case& value, Plausibility& plausibility) {
  const auto slip = slip_in_situ(value);
  if (!slip) return;
  const FractureLine& worst = value.fractures[slip->worst];
  plausibility.warn(
      worst.set.empty() ? fmt::format("fracture[{}]", slip->worst) : "natural_fractures",
      fmt::format("{} natural fracture(s) beyond their frictional strength in situ, \"{}\" by {:.6g} Pa",
                  slip->lines, worst.name, slip->excess),
      "none; they slide until they rest before the run begins, and the stress around them is then another");
}

}  // namespace

FaultList implausible_values(const Case& value, const SourceValue& document) {
  Plausibility plausibility(document);
  look_at_rock(value, plausibility);
  look_at_fluid(value, plausibility);
  look_at_treatment(value, plausibility);
  look_at_controls(value, plausibility);
  look_at_seismicity(value, plausibility);
  look_at_natural_fractures(value, plausibility);
  return std::move(plausibility).warnings();
}

}  // namespace fissura::input
