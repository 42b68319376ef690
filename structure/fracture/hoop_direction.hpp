// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/material/elasticity.hpp"
#include "structure/mesh/node_elements.hpp"

/// How a fracture goes on from the end of one whose faces slide on each other: it kinks to where the hoop
/// stress is greatest. F. Erdogan and G. C. Sih, J. Basic Eng. 85 (1963) 519.
namespace fissura::structure {

/// An end of a fracture.
struct FractureEnd {
  Point centre{};                     ///< [m]
  NodeIndex node = 0;                 ///< there
  std::array<double, 2> direction{};  ///< from the fracture into the rock, unit vector
  double h = 0;                       ///< element size there [m]
};

/// Stress intensities of an end [Pa m^0.5]: stress ahead of it  sigma_normal = K_I / sqrt(2 pi r),
/// sigma_shear = K_II / sqrt(2 pi r).
struct StressIntensity {
  double opening = 0;  ///< K_I
  double sliding = 0;  ///< K_II
};

/// Stress intensities that fit best, by area, to the stress of the elements between 1 and 4 h from the end
/// that are connected to it and not beside its faces. Fitted with them are the next two terms of the tip's
/// expansion, of order r^(1/2) (M. L. Williams, J. Appl. Mech. 24 (1957) 109), and a uniform stress, which
/// also holds what closed or wet faces carry across.
StressIntensity stress_intensity(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                                 const Elasticity& moduli, const std::vector<double>& displacement,
                                 const FractureEnd& end);

/// Angle from the direction of the end to the greatest hoop stress of the singular field, counter-clockwise
/// [rad]:
///   tan(theta / 2) = (K_I - sqrt(K_I^2 + 8 K_II^2)) / (4 K_II) ,
/// between -70.53 and 70.53 degrees; a negative K_I counts as 0, as faces do not pass through each other.
double greatest_hoop_angle(const StressIntensity& intensity);

/// The first segment from an end.
struct Kink {
  std::array<double, 2> direction{};  ///< unit vector
  double stress = 0;                  ///< across it, total, tension positive [Pa]
};

/// Kink along the greatest hoop stress. The uniform stress does not turn it: a short kink does not feel it,
/// and at the distance of an element it would hide the singular field in front of all but very long
/// fractures. The stress across it is that of the elements, all of it, averaged with the weight exp(-r^2 / (2
/// h^2) - phi^2 / (2 (20 degrees)^2)) up to 2 h from the end, phi the angle from the kink; it is to be
/// compared with the strength.
Kink greatest_hoop_kink(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                        const Elasticity& moduli, const std::vector<double>& displacement,
                        const FractureEnd& end);

}  // namespace fissura::structure
