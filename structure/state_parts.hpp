// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/byte_archive.hpp"
#include "structure/dynamics/body.hpp"
#include "structure/dynamics/damage_state.hpp"
#include "structure/joints/joint_state.hpp"
#include "structure/mesh/mesh.hpp"

/// What the members of a saved state consist of, where their bytes alone will not do (byte_archive.hpp).
namespace fissura {

constexpr FractureKind last_of(FractureKind) {
  return FractureKind::intact;
}

auto parts(EitherOf<FractureLine> auto& line) {
  return std::tie(line.name, line.kind, line.points, line.tensile_strength, line.fracture_energy,
                  line.friction_coefficient, line.cohesion, line.dilation_angle, line.dilation_slip,
                  line.residual_aperture, line.joint_compliance, line.set);
}

}  // namespace fissura

namespace fissura::structure {

auto parts(EitherOf<FractureVertex> auto& vertex) {
  return std::tie(vertex.position, vertex.units, vertex.node, vertex.edges);
}

auto parts(EitherOf<FractureEdge> auto& edge) {
  return std::tie(edge.begin, edge.end, edge.line, edge.length, edge.unit);
}

auto parts(EitherOf<PrescribedNode> auto& prescribed) {
  return std::tie(prescribed.node, prescribed.displacement, prescribed.ramp);
}

auto parts(EitherOf<ElementDamage> auto& damage) {
  return std::tie(damage.element, damage.history, damage.plastic);
}

auto parts(EitherOf<JointProperties> auto& properties) {
  return std::tie(properties.cohesive, properties.friction_coefficient, properties.friction_cohesion,
                  properties.stored_aperture, properties.residual_aperture, properties.dilation,
                  properties.dilation_slip, properties.kind);
}

auto parts(EitherOf<JointState> auto& state) {
  return std::tie(state.opening, state.sliding, state.sliding_at_rest, state.opening_rate,
                  state.greatest_separation, state.pressure, state.held_normal, state.held_tangential,
                  state.slip, state.dilation, state.closed);
}

}  // namespace fissura::structure
