// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "common/case/sections.hpp"

namespace fissura::input {

TimeSpan read_time(TableReader& document) {
  TableReader table = document.table("time");
  TimeSpan time{table.quantity("end", dimension::time, positive)};
  table.refuse_unknown_keys();
  return time;
}

Coupling read_coupling(TableReader& document) {
  TableReader table = document.optional_table("coupling");
  Coupling coupling;
  coupling.scheme = table.choice("scheme", coupling_schemes, coupling.scheme);
  coupling.minimum_steps = table.count("minimum_steps", at_least(1), coupling.minimum_steps);
  coupling.maximum_steps = table.count("maximum_steps", at_least(1), coupling.maximum_steps);
  coupling.front_fraction = table.number("front_fraction", positive, coupling.front_fraction);
  coupling.drift_tolerance = table.number("drift_tolerance", positive, coupling.drift_tolerance);
  coupling.compliance_factor =
      table.number("compliance_factor", between(0.05, 5), coupling.compliance_factor);
  coupling.maximum_interval =
      table.quantity("maximum_interval", dimension::time, positive, coupling.maximum_interval);
  coupling.fracture_normal_stiffness = table.quantity("fracture_normal_stiffness", dimension::gradient,
                                                      positive, coupling.fracture_normal_stiffness);
  if (coupling.minimum_steps > coupling.maximum_steps)
    table.refuse("minimum_steps", fmt::format("{}", coupling.minimum_steps),
                 fmt::format("at most maximum_steps, {}", coupling.maximum_steps));
  if (coupling.scheme != CouplingScheme::profit2016 && table.has("fracture_normal_stiffness"))
    table.refuse("fracture_normal_stiffness", "no such key unless scheme = \"profit2016\"");
  table.refuse_unknown_keys();
  return coupling;
}

Dynamics read_dynamics(TableReader& document) {
  TableReader table = document.optional_table("dynamics");
  Dynamics dynamics;
  dynamics.damping = table.number("damping", Range{0, 1, true, false}, dynamics.damping);
  dynamics.safety_factor = table.number("safety_factor", fraction, dynamics.safety_factor);
  dynamics.loading_ratio = table.number("loading_ratio", positive, dynamics.loading_ratio);
  dynamics.event_loading_ratio = table.number("event_loading_ratio", positive, dynamics.event_loading_ratio);
  dynamics.initial_mass_scale = table.number("initial_mass_scale", at_least(1), dynamics.initial_mass_scale);
  dynamics.maximum_mass_scale = table.number("maximum_mass_scale", at_least(1), dynamics.maximum_mass_scale);
  dynamics.equilibrate = table.flag("equilibrate", dynamics.equilibrate);
  if (dynamics.initial_mass_scale > dynamics.maximum_mass_scale)
    table.refuse("initial_mass_scale", fmt::format("{}", dynamics.initial_mass_scale),
                 fmt::format("at most maximum_mass_scale, {}", dynamics.maximum_mass_scale));
  table.refuse_unknown_keys();
  return dynamics;
}

NetworkControls read_network(TableReader& document) {
  TableReader table = document.optional_table("network");
  NetworkControls network;
  network.minimum_aperture =
      table.quantity("minimum_aperture", dimension::length, positive, network.minimum_aperture);
  network.tolerance = table.number("tolerance", between(0, 1), network.tolerance);
  network.maximum_iterations = table.count("maximum_iterations", at_least(1), network.maximum_iterations);
  table.refuse_unknown_keys();
  return network;
}

Output read_output(TableReader& document) {
  TableReader table = document.table("output");
  Output output;
  output.interval = table.quantity("interval", dimension::time, positive);
  output.reports_per_segment = table.count("reports_per_segment", at_least(1), output.reports_per_segment);
  for (TableReader& probe : table.optional_tables("probe")) {
    output.probes.push_back({probe.text("name"), probe.vector("position", dimension::length)});
    probe.refuse_unknown_keys();
  }
  table.refuse_unknown_keys();
  return output;
}

std::vector<InitialVelocity> read_initial_velocities(TableReader& document) {
  std::vector<InitialVelocity> moving;
  for (TableReader& table : document.optional_tables("initial_velocity")) {
    InitialVelocity& part = moving.emplace_back();
    part.velocity = table.vector("velocity", dimension::velocity);
    part.west = table.quantity("west", dimension::length, any_value);
    part.east = table.quantity("east", dimension::length, any_value);
    part.south = table.quantity("south", dimension::length, any_value);
    part.north = table.quantity("north", dimension::length, any_value);
    table.refuse_unknown_keys();
  }
  return moving;
}

Deadlines read_deadlines(TableReader& document) {
  TableReader table = document.optional_table("deadlines");
  Deadlines deadlines;
  deadlines.join = table.quantity("join", dimension::time, positive, deadlines.join);
  deadlines.progress = table.quantity("progress", dimension::time, positive, deadlines.progress);
  deadlines.finish = table.quantity("finish", dimension::time, positive, deadlines.finish);
  table.refuse_unknown_keys();
  return deadlines;
}

CheckpointControls read_checkpoint(TableReader& document) {
  TableReader table = document.optional_table("checkpoint");
  CheckpointControls checkpoint;
  checkpoint.interval = table.quantity("interval", dimension::time, not_negative, checkpoint.interval);
  checkpoint.intervals = table.count("intervals", not_negative, checkpoint.intervals);
  checkpoint.keep = table.count("keep", at_least(2), checkpoint.keep);
  table.refuse_unknown_keys();
  return checkpoint;
}

PressureRange read_pressure_range(TableReader& document) {
  TableReader table = document.optional_table("pressure_range");
  PressureRange range;
  range.minimum = table.quantity("minimum", dimension::stress, any_value, range.minimum);
  range.maximum = table.quantity("maximum", dimension::stress, any_value, range.maximum);
  if (range.minimum >= range.maximum)
    table.refuse("maximum", fmt::format("{} Pa", range.maximum),
                 fmt::format("greater than minimum, {} Pa", range.minimum));
  table.refuse_unknown_keys();
  return range;
}

}  // namespace fissura::input
