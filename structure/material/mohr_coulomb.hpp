// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/material/elasticity.hpp"
#include "structure/material/failure_trigger.hpp"

/// Mohr-Coulomb plasticity with dilation: perfectly plastic, flow by the Mohr-Coulomb potential of the
/// dilation angle psi, implicit return in principal stresses (de Souza Neto, Peric & Owen 2008, Sect. 8.2).
/// Tension positive.
///   surface    F = (s_1 - s_3) + (s_1 + s_3) sin(phi) - 2 c cos(phi) <= 0 ,   s_1 >= s_2 >= s_3
///   flow       eps_p += dlambda b ,   b = (1 + sin(psi), 0, -(1 - sin(psi)))
/// A stress that the return to this plane would put out of order ends on the edge with the neighbouring
/// plane, one that no edge can take at the apex  s_1 = s_2 = s_3 = c cot(phi) .
namespace fissura::structure {

struct MohrCoulomb {
  Elasticity moduli;
  MohrCoulombSurface surface;
  double sine_dilation = 0;  ///< sin(psi), at most sin(phi)
};

/// F of principal stresses s_1 >= s_2 >= s_3 [Pa].
double yield_value(const MohrCoulombSurface& surface, const std::array<double, 3>& stress);

/// Where a return ends.
enum class ReturnedTo { inside, plane, right_edge, left_edge, apex };

/// Principal stresses on or inside the surface [Pa] and the plastic strain that brought them there [-].
struct PlasticReturn {
  std::array<double, 3> stress{}, strain{};
  ReturnedTo place = ReturnedTo::inside;
};

/// Returns the elastic predictor s_1 >= s_2 >= s_3 [Pa] to the surface. A crack transmits only the fraction
/// `transmitted` of each principal stress, 1 without a crack: the surface bounds the stresses transmitted,
/// the ones returned are the undamaged ones. Cracks that open leave room, so sin(psi) is lowered by the least
/// fraction.
PlasticReturn return_to_surface(const MohrCoulomb& law, const std::array<double, 3>& predictor,
                                const std::array<double, 3>& transmitted);

}  // namespace fissura::structure
