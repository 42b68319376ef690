// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/dynamics/body.hpp"
#include "structure/material/mohr_circle.hpp"
#include "structure/mesh/node_elements.hpp"

namespace fissura::structure {

/// The half disc ahead of a tip over which a stress is averaged. The weight of an element is its area times exp(-d^2 / (2 width^2)),
/// d from the tip to its centroid.
struct HalfDisc {
  Point centre{};                     ///< the tip [m]
  NodeIndex node = 0;                 ///< there
  std::array<double, 2> direction{};  ///< its axis, unit vector
  double radius = 0;                  ///< [m]
  double width = 0;                   ///< of the Gaussian [m]
};

/// Average of the total stress tensor (effective minus Biot times pore pressure, undamaged, tension positive [Pa]) over the elements of
/// the half disc that are connected to the tip through nodes, so that nothing is averaged across a fracture. The tensor is averaged, not
/// the angles of its axes. @pre the disc holds a centroid, else the stress of the elements at the tip is averaged.
InPlane<double> average_stress(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                               const Elasticity& moduli, const std::vector<double>& displacement, const HalfDisc& disc);

}  // namespace fissura::structure
