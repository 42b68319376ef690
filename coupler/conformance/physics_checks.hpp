// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "coupler/conformance/check.hpp"

/// What fluid must do, tried against closed forms and balances that each check works out by hand.
namespace fissura::coupler::conformance {

/// All of them, in the order of flow_solvers.md 3.
std::vector<Check> physics_checks();

// One function for each file.
std::vector<Check> storage_checks();
std::vector<Check> filling_checks();
std::vector<Check> cubic_law_checks();
std::vector<Check> diffusion_checks();
std::vector<Check> schedule_checks();
std::vector<Check> well_checks();
std::vector<Check> leak_off_checks();
std::vector<Check> natural_checks();
std::vector<Check> fluid_checks();
std::vector<Check> balance_checks();
std::vector<Check> transfer_checks();
std::vector<Check> extreme_checks();

}  // namespace fissura::coupler::conformance
