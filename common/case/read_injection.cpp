// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

constexpr double well_index_of_a_free_perforation = 1e-5;

std::string controls_given(bool rate, bool pressure, bool shut_in) {
  std::vector<std::string> given;
  if (rate) given.emplace_back("rate");
  if (pressure) given.emplace_back("pressure");
  if (shut_in) given.emplace_back("shut_in");
  return given.empty() ? "none of them" : listed(given);
}

void read_rheology(TableReader& table, Fluid& fluid) {
  const bool newtonian = table.has("viscosity");
  if (newtonian == table.has("consistency_index")) {
    table.refuse("viscosity", newtonian ? "viscosity and consistency_index" : "nothing",
                 "either viscosity, or consistency_index with power_index");
    return;
  }
  if (newtonian) {
    fluid.consistency_index = table.quantity("viscosity", dimension::viscosity, positive);
    if (table.has("power_index")) table.refuse("power_index", "no such key beside viscosity");
    return;
  }
  fluid.power_index = table.number("power_index", between(0, 2));
  fluid.consistency_index =
      table.quantity("consistency_index", dimension::consistency_index(fluid.power_index), positive);
}

Fluid read_fluid(TableReader& table) {
  Fluid fluid;
  fluid.name = table.text("name");
  read_rheology(table, fluid);
  fluid.bulk_modulus = table.quantity("bulk_modulus", dimension::stress, positive);
  table.refuse_unknown_keys();
  return fluid;
}

Perforation read_perforation(TableReader& table) {
  Perforation perforation;
  perforation.name = table.text("name");
  perforation.position = table.vector("position", dimension::length);
  perforation.aperture = table.quantity("aperture", dimension::length, positive);
  table.refuse_unknown_keys();
  return perforation;
}

Stage read_stage(TableReader& table) {
  Stage stage;
  stage.begin = table.quantity("begin", dimension::time, not_negative);
  const bool shut_in = table.flag("shut_in", false);
  const bool rate = table.has("rate"), pressure = table.has("pressure");
  if (int{shut_in} + int{rate} + int{pressure} != 1)
    table.refuse("rate", controls_given(rate, pressure, shut_in),
                 "exactly one of rate, pressure and shut_in = true");
  if (rate) {
    stage.control = StageControl::rate;
    stage.rate = table.quantity("rate", dimension::rate, any_value);
  } else if (pressure) {
    stage.control = StageControl::pressure;
    stage.pressure = table.quantity("pressure", dimension::stress, not_negative);
  } else {
    stage.control = StageControl::shut_in;
  }
  if (shut_in && table.has("fluid")) table.refuse("fluid", "no fluid with shut_in = true");
  if (rate || pressure) stage.fluid = table.text("fluid");
  stage.ramp = table.quantity("ramp", dimension::time, not_negative, stage.ramp);
  table.refuse_unknown_keys();
  return stage;
}

}  // namespace

std::vector<Fluid> read_fluids(TableReader& document) {
  std::vector<Fluid> fluids;
  for (TableReader& table : document.optional_tables("fluid")) {
    fluids.push_back(read_fluid(table));
    const auto same_name = [&](const Fluid& fluid) { return fluid.name == fluids.back().name; };
    if (!fluids.back().name.empty() && std::any_of(fluids.begin(), fluids.end() - 1, same_name))
      table.refuse("name", "a name that no other fluid has");
  }
  return fluids;
}

LeakOff read_leak_off(TableReader& document) {
  LeakOff leak_off;
  if (!document.has("leak_off")) return leak_off;
  TableReader table = document.table("leak_off");
  leak_off.coefficient = table.quantity("coefficient", dimension::carter_coefficient, not_negative);
  leak_off.spurt_volume =
      table.quantity("spurt_volume", dimension::volume_per_area, not_negative, leak_off.spurt_volume);
  table.refuse_unknown_keys();
  return leak_off;
}

Injection read_injection(TableReader& document) {
  Injection injection;
  if (!document.has("injection")) return injection;
  TableReader table = document.table("injection");
  injection.well_index =
      table.quantity("well_index", dimension::well_index, positive, well_index_of_a_free_perforation);
  for (TableReader& perforation : table.tables("perforation"))
    injection.perforations.push_back(read_perforation(perforation));
  for (TableReader& stage : table.tables("stage")) injection.stages.push_back(read_stage(stage));
  table.refuse_unknown_keys();
  return injection;
}

}  // namespace fissura::input
