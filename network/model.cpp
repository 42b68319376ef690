// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"

namespace fissura::network {

namespace {

void require_positive(double value, const std::string& what) {
  if (!(std::isfinite(value) && value > 0))
    throw InputError(fmt::format("{} must be positive, found {}", what, value));
}

void require_not_negative(double value, const std::string& what) {
  if (!(std::isfinite(value) && value >= 0))
    throw InputError(fmt::format("{} must not be negative, found {}", what, value));
}

std::size_t fluid_named(const std::vector<FractureFluid>& fluids, const std::string& name) {
  const auto found = std::find_if(fluids.begin(), fluids.end(),
                                  [&](const FractureFluid& fluid) { return fluid.name == name; });
  if (found == fluids.end())
    throw InputError(fmt::format("a pumping stage injects \"{}\", which is not a fluid of the case", name));
  return static_cast<std::size_t>(found - fluids.begin());
}

PumpingStage pumping_stage(const Stage& stage, const std::vector<FractureFluid>& fluids, double thickness) {
  PumpingStage result{
      .begin = stage.begin, .control = WellControl::rate, .target = 0, .ramp = stage.ramp, .fluid = {}};
  switch (stage.control) {
    case StageControl::shut_in:
      return result;
    case StageControl::rate:
      result.target = stage.rate / thickness;
      break;
    case StageControl::pressure:
      require_not_negative(stage.pressure, "the well pressure of a pumping stage");
      result.control = WellControl::pressure;
      result.target = stage.pressure;
      break;
  }
  result.fluid = fluid_named(fluids, stage.fluid);
  return result;
}

}  // namespace

bool Model::newtonian() const {
  return std::all_of(fluids.begin(), fluids.end(),
                     [](const FractureFluid& fluid) { return fluid.law.newtonian(); });
}

Model model_from_case(const Case& value) {
  Model model;
  require_positive(value.domain.thickness, "domain.thickness");
  model.dry = value.injection.perforations.empty() && value.injection.stages.empty();
  if (!model.dry) require_positive(value.injection.well_index, "injection.well_index");
  require_positive(value.network.minimum_aperture, "network.minimum_aperture");
  require_positive(value.network.tolerance, "network.tolerance");
  require_positive(value.network.maximum_iterations, "network.maximum_iterations");
  require_not_negative(value.leak_off.coefficient, "leak_off.coefficient");
  require_not_negative(value.leak_off.spurt_volume, "leak_off.spurt_volume");
  if (value.fluids.empty() && !model.dry) throw InputError("the case has no fluid, expected at least one");
  for (const Fluid& fluid : value.fluids) {
    require_positive(fluid.consistency_index, "the consistency index of fluid \"" + fluid.name + "\"");
    require_positive(fluid.power_index, "the power index of fluid \"" + fluid.name + "\"");
    require_positive(fluid.bulk_modulus, "the bulk modulus of fluid \"" + fluid.name + "\"");
    model.fluids.push_back({fluid.name, {fluid.consistency_index, fluid.power_index}, fluid.bulk_modulus});
  }
  std::vector<PumpingStage> stages;
  for (const Stage& stage : value.injection.stages)
    stages.push_back(pumping_stage(stage, model.fluids, value.domain.thickness));
  model.schedule = Schedule(std::move(stages));
  model.leak_off = {value.leak_off.coefficient, value.leak_off.spurt_volume};
  model.well_index = value.injection.well_index;
  model.thickness = value.domain.thickness;
  model.minimum_aperture = value.network.minimum_aperture;
  model.tolerance = value.network.tolerance;
  model.maximum_iterations = value.network.maximum_iterations;
  return model;
}

}  // namespace fissura::network
