// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/wet_release.hpp"

#include <algorithm>
#include <set>

namespace fissura::structure {

namespace {

double pressure_at(const Mesh& mesh, const Joints& joints, VertexIndex vertex) {
  double pressure = 0;
  for (const UnitIndex unit : mesh.vertices[vertex].units)
    pressure = std::max(pressure, joints.state[unit].pressure);
  return pressure;
}

bool strength_reached(const Mesh& mesh, const Joints& joints, VertexIndex ahead, double adjacent_pressure) {
  const auto& units = mesh.vertices[ahead].units;
  return std::any_of(units.begin(), units.end(), [&](UnitIndex unit) {
    return joints.state[unit].held_normal + adjacent_pressure >= joints.properties[unit].cohesive.strength;
  });
}

}  // namespace

std::vector<VertexIndex> vertices_to_release(const Mesh& mesh, const Joints& joints,
                                             const FractureNetwork& network) {
  std::set<VertexIndex> found;
  for (const FractureEdge& edge : mesh.edges) {
    const bool begin_in = network.contains(edge.begin), end_in = network.contains(edge.end);
    if (begin_in == end_in) continue;
    const VertexIndex last = begin_in ? edge.begin : edge.end, ahead = begin_in ? edge.end : edge.begin;
    if (strength_reached(mesh, joints, ahead, pressure_at(mesh, joints, last))) found.insert(ahead);
  }
  return {found.begin(), found.end()};
}

void release(const Mesh& mesh, VertexIndex vertex, Joints& joints) {
  for (const UnitIndex unit : mesh.vertices[vertex].units) {
    if (joints.released[unit]) continue;
    joints.released[unit] = 1;
    joints.ramp[unit] = {};
    joints.state[unit].pressure = 0;
    joints.state[unit].closed = true;
  }
}

}  // namespace fissura::structure
