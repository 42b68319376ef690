// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/joints/block_pair.hpp"

namespace fissura::structure::fakes {

namespace {

Mesh one_unit(double length) {
  Mesh mesh;
  mesh.position = {{0, 0}, {0, 0}};
  ContactUnit unit;
  unit.minus = 0;
  unit.plus = 1;
  unit.face = {0, length};
  unit.length = length;
  mesh.units = {unit};
  FractureVertex vertex;
  vertex.units = {0};
  mesh.vertices = {vertex};
  return mesh;
}

}  // namespace

BlockPair::BlockPair(const JointProperties& properties, double mass, double length)
    : mesh_(one_unit(length)),
      mass_{mass, mass},
      displacement_(4, 0),
      velocity_(4, 0),
      joint_step_(mesh_, nodes_, 1) {
  joints_.properties = {properties};
  joints_.state.resize(1);
  joints_.released = {1};
  joints_.ramp.resize(1);
}

void BlockPair::step(Point force_minus, Point force_plus, const JointStepControls& controls) {
  const std::vector<double> force{force_minus[0], force_minus[1], force_plus[0], force_plus[1]};
  joint_step_.advance({force, nodes_, mass_, displacement_, velocity_}, controls, joints_);
}

void BlockPair::set_velocity_plus(Point velocity) {
  velocity_[2] = velocity[0];
  velocity_[3] = velocity[1];
}

}  // namespace fissura::structure::fakes
