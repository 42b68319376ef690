// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura::coupler {

/// The principal values of a stress of the plane, tension positive [Pa].
struct PrincipalStress {
  double least_compression = 0;     ///< the larger value
  double greatest_compression = 0;  ///< the smaller value
  double angle =
      0;  ///< direction of the greatest compression, counter-clockwise from x, in (-pi/2, pi/2] [rad]
};

/// Eigenvalues and directions of the stress with components xx, yy, xy [Pa]. An isotropic stress has the
/// angle 0.
PrincipalStress principal_stress(double xx, double yy, double xy);

}  // namespace fissura::coupler
