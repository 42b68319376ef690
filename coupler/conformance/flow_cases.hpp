// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"

/// Cases of which only what a flow solver reads matters; a check changes what it is about.
namespace fissura::coupler::conformance {

/// One Newtonian fluid like water (viscosity 1e-3 Pa s, bulk modulus 2 GPa) pumped at `rate` [m3/s, whole
/// thickness of 2 m] from time 0 into the perforation "well"; no leak-off.
Case water_case(double rate);

/// Adds a stage of constant rate of the first fluid; 0 is a shut-in.
void add_stage(Case& run_case, double begin, double rate);

}  // namespace fissura::coupler::conformance
