// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "structure/dynamics/body.hpp"
#include "structure/material/mohr_circle.hpp"
#include "structure/mesh/node_elements.hpp"

namespace fissura::structure {

/// The half disc ahead of a tip over which a stress is averaged, with the weight
///   exp(-r^2 / (2 width^2))                       (Weighting::near)
///   (r cos(theta))^2 exp(-r^2 / (2 width^2))      (Weighting::ahead)
/// at the distance r from the tip and the angle theta from its axis. The second one vanishes at the straight edge of the half disc, where
/// the principal directions turn most and one element more on one side would turn the average.
struct HalfDisc {
  enum class Weighting { near, ahead };
  Point centre{};                     ///< the tip [m]
  NodeIndex node = 0;                 ///< there
  std::array<double, 2> direction{};  ///< its axis, unit vector
  double radius = 0;                  ///< [m]
  double width = 0;                   ///< [m]
  Weighting weighting = Weighting::near;
};

/// Average of the total stress tensor (effective minus Biot times pore pressure, undamaged, tension positive [Pa]) over the part of the
/// half disc that is connected to the tip through nodes, so that nothing is averaged across a fracture. The weight is integrated over
/// every element, so that it counts with the part of it that lies in the disc. The tensor is averaged, not the angles of its axes.
/// Where no element reaches into the disc, the stress of those at the tip is averaged.
InPlane<double> average_stress(const Mesh& mesh, const NodeElements& node_elements, const Body& body,
                               const Elasticity& moduli, const std::vector<double>& displacement, const HalfDisc& disc);

}  // namespace fissura::structure
