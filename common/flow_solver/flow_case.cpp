// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/flow_solver/flow_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "common/exact_json.hpp"
#include "common/flow_solver/flow_solver.hpp"
#include "common/solver_case_hash.hpp"

namespace fissura {

namespace {

/// Throws InputError unless `value` is finite and positive.
double positive(double value, const std::string& what) {
  if (!(std::isfinite(value) && value > 0))
    throw InputError(fmt::format("{} must be positive, found {}", what, value));
  return value;
}

double not_negative(double value, const std::string& what) {
  if (!(std::isfinite(value) && value >= 0))
    throw InputError(fmt::format("{} must not be negative, found {}", what, value));
  return value;
}

double number(const nlohmann::json& object, const char* key) {
  return exactly<double>(object.at(key));
}

FlowFluid fluid_of(const nlohmann::json& json) {
  FlowFluid fluid;
  fluid.name = json.at("name").get<std::string>();
  const std::string of = " of fluid \"" + fluid.name + "\"";
  fluid.consistency_index = positive(number(json, "consistency_index"), "the consistency index" + of);
  fluid.power_index = positive(number(json, "power_index"), "the power index" + of);
  fluid.bulk_modulus = positive(number(json, "bulk_modulus"), "the bulk modulus" + of);
  return fluid;
}

std::size_t fluid_named(const std::vector<FlowFluid>& fluids, const std::string& name) {
  const auto found = std::ranges::find(fluids, name, &FlowFluid::name);
  if (found == fluids.end())
    throw InputError(fmt::format("a pumping stage injects \"{}\", which is not a fluid of the case", name));
  return static_cast<std::size_t>(found - fluids.begin());
}

PumpingStage stage_of(const nlohmann::json& json, const FlowCase& so_far) {
  PumpingStage stage;
  stage.begin = number(json, "begin");
  stage.ramp = not_negative(number(json, "ramp"), "the ramp of a pumping stage");
  const auto control = json.at("control").get<std::string>();
  if (control == "shut_in") return stage;
  if (control == "rate") {
    stage.target = number(json, "rate") / so_far.thickness;
  } else if (control == "pressure") {
    stage.control = WellControl::pressure;
    stage.target = not_negative(number(json, "pressure"), "the well pressure of a pumping stage");
  } else {
    throw InputError(fmt::format(
        "a pumping stage is controlled by \"{}\", expected \"rate\", \"pressure\" or \"shut_in\"", control));
  }
  stage.fluid = fluid_named(so_far.fluids, json.at("fluid").get<std::string>());
  return stage;
}

void require_order(const std::vector<PumpingStage>& stages) {
  for (std::size_t k = 1; k < stages.size(); ++k)
    if (stages[k].begin <= stages[k - 1].begin)
      throw InputError(fmt::format("pumping stage {} begins at {} s, expected later than stage {} at {} s", k,
                                   stages[k].begin, k - 1, stages[k - 1].begin));
}

FlowCase read(const nlohmann::json& json) {
  FlowCase flow;
  flow.hash = solver_case_hash(json);
  const nlohmann::json &injection = json.at("injection"), &network = json.at("network"),
                       &leak_off = json.at("leak_off");
  flow.dry = injection.at("perforations").empty() && injection.at("stages").empty();
  flow.thickness = positive(number(json.at("domain"), "thickness"), "domain.thickness");
  flow.well_index = number(injection, "well_index");
  if (!flow.dry) positive(flow.well_index, "injection.well_index");
  flow.minimum_aperture = positive(number(network, "minimum_aperture"), "network.minimum_aperture");
  flow.tolerance = positive(number(network, "tolerance"), "network.tolerance");
  flow.maximum_iterations = exactly<int>(network.at("maximum_iterations"));
  positive(flow.maximum_iterations, "network.maximum_iterations");
  flow.leak_off_coefficient = not_negative(number(leak_off, "coefficient"), "leak_off.coefficient");
  flow.spurt_volume = not_negative(number(leak_off, "spurt_volume"), "leak_off.spurt_volume");
  for (const nlohmann::json& fluid : json.at("fluids")) flow.fluids.push_back(fluid_of(fluid));
  if (flow.fluids.empty() && !flow.dry) throw InputError("the case has no fluid, expected at least one");
  for (const nlohmann::json& stage : injection.at("stages")) flow.stages.push_back(stage_of(stage, flow));
  require_order(flow.stages);
  return flow;
}

std::set<std::string> physics_of(const nlohmann::json& json) {
  std::set<std::string> needed;
  const FlowCase flow = read(json);
  if (flow.leak_off_coefficient > 0 || flow.spurt_volume > 0) needed.insert(claims::leak_off);
  std::set<std::size_t> pumped;
  for (const PumpingStage& stage : flow.stages) {
    if (stage.control == WellControl::pressure) needed.insert(claims::pressure_control);
    if (stage.fluid) pumped.insert(*stage.fluid);
  }
  if (pumped.size() > 1) needed.insert(claims::several_fluids);
  for (const std::size_t fluid : pumped)
    if (flow.fluids[fluid].power_index != 1) needed.insert(claims::power_law);
  for (const nlohmann::json& fracture : json.at("fractures"))
    if (fracture.at("kind") == "natural" && !flow.dry) needed.insert(claims::natural_fractures);
  if (json.at("coupling").at("scheme") == "profit2016") needed.insert(claims::carry_pressure);
  return needed;
}

template <typename Read>
auto of_complete_case(const Read& read_it) {
  try {
    return read_it();
  } catch (const nlohmann::json::exception& error) {
    throw ProtocolError(fmt::format("the case received is not complete: {}", error.what()));
  }
}

}  // namespace

FlowCase flow_case(const nlohmann::json& run_case) {
  return of_complete_case([&] { return read(run_case); });
}

std::set<std::string> needed_physics(const nlohmann::json& run_case) {
  return of_complete_case([&] { return physics_of(run_case); });
}

}  // namespace fissura
