// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/dynamics/pair.hpp"

/// Central differences of one node, component by component, with lumped mass and Cundall's local damping
/// (Cundall 1987):
///   F         = f_internal(u^n) + f_external
///   v^{n+1/2} = v^{n-1/2} + dt / (mass_scale m) (F - damping |F| sign(v^{n-1/2})) ,   sign(0) = 0
///   u^{n+1}   = u^n + dt v^{n+1/2}
namespace fissura::structure {

struct Step {
  double size = 0;        ///< dt [s]
  double end = 0;         ///< simulated time after the step [s], for prescribed displacements
  double mass_scale = 1;  ///< of all masses alike [-]
  double damping = 0;     ///< local damping [-], 0 <= damping < 1
};

/// A step as the nodes use it.
struct StepFactors {
  double size;     ///< dt [s]
  double impulse;  ///< dt / mass_scale [s]
  double damping;  ///< [-]

  explicit StepFactors(const Step& step)
      : size(step.size), impulse(step.size / step.mass_scale), damping(step.damping) {}
};

/// Moves a node. F [N/m] and the inverse unscaled mass [m/kg] are given by component; `velocity` [m/s] and
/// `displacement` [m] point to the two components of the node. A component without inverse mass keeps its
/// velocity.
inline void integrate(const Pair& force, const Pair& inverse_mass, const StepFactors& factors,
                      double* velocity, double* displacement) {
  const Pair before = load_pair(velocity);
  const Pair magnitude = force < 0.0 ? -force : force;
  const Pair drag = factors.damping * magnitude;
  const Pair none{0, 0};
  const Pair signed_drag = before > 0.0 ? drag : (before < 0.0 ? -drag : none);
  const Pair after = before + factors.impulse * inverse_mass * (force - signed_drag);
  store_pair(velocity, after);
  store_pair(displacement, load_pair(displacement) + factors.size * after);
}

}  // namespace fissura::structure
