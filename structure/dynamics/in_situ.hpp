// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "common/case/case.hpp"
#include "structure/material/elasticity.hpp"

/// The in-situ state of a case, a linear field.
namespace fissura::structure {

struct InSituState {
  InPlane<double> stress{};  ///< effective, tension positive [Pa]
  double out_of_plane = 0;   ///< effective sigma_zz [Pa]
  double pore_pressure = 0;  ///< Biot coefficient times pore pressure [Pa]
};

/// State at a point [m].
InSituState in_situ_state(const Case& settings, const Point& position);

/// In-plane total stress, effective stress - alpha p  [Pa].
constexpr InPlane<double> total_stress(const InSituState& state) {
  return {state.stress.xx - state.pore_pressure, state.stress.yy - state.pore_pressure, state.stress.xy};
}

/// stress . normal; [Pa] for a unit normal, [N/m] for a normal that carries a length [m].
constexpr std::array<double, 2> traction(const InPlane<double>& stress, const std::array<double, 2>& normal) {
  return {stress.xx * normal[0] + stress.xy * normal[1], stress.xy * normal[0] + stress.yy * normal[1]};
}

}  // namespace fissura::structure
