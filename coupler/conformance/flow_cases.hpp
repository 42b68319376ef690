// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"

/// Cases of which only what a flow solver reads matters; a check changes what it is about.
namespace fissura::coupler::conformance {

namespace water {
inline constexpr double viscosity = 1e-3;    ///< [Pa s]
inline constexpr double bulk_modulus = 2e9;  ///< [Pa]
inline constexpr double thickness = 2;       ///< of the layer [m]
inline constexpr double well_index = 1e-6;   ///< [m2/(s Pa)]
}  // namespace water

/// One Newtonian fluid, water, pumped at `rate` [m3/s, whole thickness] from time 0 into the perforation
/// "well"; no leak-off.
Case water_case(double rate);

/// Adds a stage of constant rate of the first fluid; 0 is a shut-in.
void add_stage(Case& run_case, double begin, double rate);

}  // namespace fissura::coupler::conformance
