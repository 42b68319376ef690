// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace fissura {

/// A fluid that is pumped: tau = K gamma^n; Newtonian for n = 1 with K the viscosity.
struct FlowFluid {
  std::string name;
  double consistency_index = 0;  ///< K [Pa s^n], > 0
  double power_index = 1;        ///< n [-], > 0
  double bulk_modulus = 0;       ///< K_f [Pa], > 0
};

enum class WellControl { rate, pressure };

/// One stage of the pumping schedule; it lasts until the next begins. A shut-in is a rate of zero without a
/// fluid.
struct PumpingStage {
  double begin = 0;  ///< [s]
  WellControl control = WellControl::rate;
  double target = 0;                 ///< rate per unit thickness [m2/s], or well pressure [Pa]
  double ramp = 0;                   ///< the target is reached linearly within this time [s]
  std::optional<std::size_t> fluid;  ///< injected; none for a shut-in
};

/// What a case asks of a flow solver, checked. Never changes during a run.
struct FlowCase {
  std::string hash;               ///< of all that the state of a solver depends on: equal cases, equal hashes
  double thickness = 0;           ///< H [m], > 0
  std::vector<FlowFluid> fluids;  ///< at least one, unless dry
  double leak_off_coefficient = 0;  ///< C_l of ONE face [m/s^0.5], >= 0
  double spurt_volume = 0;          ///< S_p of one face [m3/m2], >= 0
  double well_index = 0;        ///< WI of one perforation, per unit thickness [m2/(s Pa)]: q = WI (p_w - p)
  double minimum_aperture = 0;  ///< floor of the aperture in the conductance only [m], > 0
  double tolerance = 0;         ///< of an iterative solution, relative to the content moved [-], > 0
  int maximum_iterations = 0;   ///< of an iterative solution, > 0
  std::vector<PumpingStage> stages;  ///< begins increase; before the first the well is shut in
  bool dry = false;                  ///< nothing is ever pumped: every pressure is zero
};

/// The case as WELCOME brings it (SI; keys as in docs/protocol.md) as far as a flow solver needs it. A case
/// without perforations and stages is dry. Throws InputError if any other has no fluid, a stage names an
/// unknown one, begins do not increase, or a number is outside its physical range; ProtocolError if a key is
/// missing.
FlowCase flow_case(const nlohmann::json& run_case);

/// Names of `claims` (flow_solver.hpp) that a solver must make for this case. Throws as flow_case.
std::set<std::string> needed_physics(const nlohmann::json& run_case);

}  // namespace fissura
