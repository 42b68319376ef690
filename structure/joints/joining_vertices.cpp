// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/joining_vertices.hpp"

#include <algorithm>
#include <set>

#include "structure/joints/network_topology.hpp"

namespace fissura::structure {

namespace {

bool holds_pore_fluid(const Mesh& mesh, const Joints& joints, VertexIndex vertex) {
  const auto& units = mesh.vertices[vertex].units;
  return std::any_of(units.begin(), units.end(), [&](UnitIndex unit) {
    const JointProperties& properties = joints.properties[unit];
    const bool permeable = properties.cohesive.strength == 0 || joints.broken(unit);
    return permeable && joints.released[unit] && properties.kind != FractureKind::open;
  });
}

}  // namespace

std::vector<VertexIndex> joining_vertices(const Mesh& mesh, const Joints& joints,
                                          const FractureNetwork& network, const Arrivals& arrivals) {
  const std::set<VertexIndex> split(arrivals.split.begin(), arrivals.split.end());
  std::set<VertexIndex> joining(arrivals.nucleated.begin(), arrivals.nucleated.end());
  std::vector<VertexIndex> front = arrivals.nucleated;
  for (const NetworkNode& node : network.nodes()) front.push_back(vertex_of(node.id));
  while (!front.empty()) {
    const VertexIndex vertex = front.back();
    front.pop_back();
    for (const EdgeIndex edge : mesh.vertices[vertex].edges) {
      const VertexIndex next = mesh.edges[edge].across(vertex);
      if (network.contains(next) || joining.contains(next)) continue;
      if (!split.contains(next) && !holds_pore_fluid(mesh, joints, next)) continue;
      joining.insert(next);
      front.push_back(next);
    }
  }
  return {joining.begin(), joining.end()};
}

}  // namespace fissura::structure
