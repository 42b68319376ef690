// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace fissura::coupler {

/// What the run was to give, from the copies in its own `input` folder, in SI:
///   curves  {column of history.csv: {"time" [s], "value"}} of the references of expected.toml
///   points  [{"name", "time" [s], "value", "tolerance" [-]}] of the quantities that are expected at one time
///   remark  why something is missing; empty if nothing is
/// `end_time` is that of the case [s], `probes` are the names of its probes.
nlohmann::json comparison(const std::filesystem::path& run_directory, double end_time,
                          const std::vector<std::string>& probes);

/// The classical solution (classical_kgd.hpp) at the same columns up to `last_time` [s]: {"time",
/// "half_length", "inlet_aperture", "inlet_net_pressure"}; null where it does not apply.
nlohmann::json classical_curves(const nlohmann::json& effective_case, double last_time);

}  // namespace fissura::coupler
