// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/network_topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "common/errors.hpp"
#include "structure/joints/joining_vertices.hpp"

namespace fissura::structure {

namespace {

SegmentKind segment_kind(FractureKind kind) {
  return kind == FractureKind::natural ? SegmentKind::natural : SegmentKind::hydraulic;
}

NetworkNode make_node(const Mesh& mesh, VertexIndex index, const Case& run_case, double time) {
  const FractureVertex& vertex = mesh.vertices[index];
  NetworkNode node;
  node.id = index;
  node.x = vertex.position[0];
  node.y = vertex.position[1];
  node.saturated = std::any_of(vertex.units.begin(), vertex.units.end(), [&](UnitIndex unit) {
    return mesh.lines[mesh.units[unit].line].kind == FractureKind::natural;
  });
  node.formation_pressure = pore_pressure(run_case.in_situ, vertex.position);
  double strength = -1;
  for (const EdgeIndex at : vertex.edges) {
    const FractureEdge& edge = mesh.edges[at];
    const FractureLine& line = mesh.lines[edge.line];
    node.lumped_length += edge.length / 2;
    node.joint_compliance += edge.length / 2 * line.joint_compliance;
    if (line.tensile_strength <= strength) continue;
    strength = line.tensile_strength;
    node.fracture = edge.line;
  }
  node.joint_compliance /= node.lumped_length;
  node.exposure_time = time;
  return node;
}

NodeRole role_of(std::size_t degree, bool perforated) {
  if (perforated) return NodeRole::perforation;
  if (degree > 2) return NodeRole::junction;
  return degree == 2 ? NodeRole::interior : NodeRole::tip;
}

/// Completes `insertion` (its new nodes given) with segments, parents and roles.
void connect_nodes(const Mesh& mesh, const FractureNetwork& network, const Case& run_case,
                   Insertion& insertion) {
  std::set<VertexIndex> members, added;
  for (const NetworkNode& node : network.nodes()) members.insert(vertex_of(node.id));
  for (const NetworkNode& node : insertion.new_nodes) added.insert(vertex_of(node.id));
  members.insert(added.begin(), added.end());

  std::vector<std::size_t> degree(mesh.vertices.size(), 0);
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const FractureEdge& edge = mesh.edges[k];
    if (!members.contains(edge.begin) || !members.contains(edge.end)) continue;
    ++degree[edge.begin];
    ++degree[edge.end];
    const bool begin_new = added.contains(edge.begin), end_new = added.contains(edge.end);
    if (network.knows_segment(k)) continue;
    insertion.new_segments.push_back(
        {k, edge.begin, edge.end, edge.line, segment_kind(mesh.lines[edge.line].kind), edge.length});
    if (begin_new && !end_new) insertion.parents.push_back({edge.begin, edge.end});
    if (end_new && !begin_new) insertion.parents.push_back({edge.end, edge.begin});
  }

  const auto& given = insertion.new_perforations;
  const auto perforated = [&](NodeId id) {
    const auto same = [id](const PerforationNode& perforation) { return perforation.node == id; };
    return std::any_of(given.begin(), given.end(), same) ||
           std::any_of(network.perforations().begin(), network.perforations().end(), same);
  };
  for (NetworkNode& node : insertion.new_nodes)
    node.role = role_of(degree[vertex_of(node.id)], perforated(node.id));
  // An edge that the network does not reach yet lengthens the nodes it begins at.
  for (const VertexIndex vertex : members) {
    if (added.contains(vertex)) continue;
    NetworkNode node = network.nodes()[network.index_of(vertex)];
    const NodeRole role = role_of(degree[vertex], perforated(node.id));
    const NetworkNode now = make_node(mesh, vertex, run_case, node.exposure_time);
    if (role == node.role && now.lumped_length == node.lumped_length) continue;
    node.role = role;
    node.lumped_length = now.lumped_length;
    node.joint_compliance = now.joint_compliance;
    insertion.updated_nodes.push_back(node);
  }
}

/// Natural fractures that the open ones of `insertion` touch.
std::vector<VertexIndex> touched_by(const Mesh& mesh, const Joints& joints, const Insertion& insertion) {
  FractureNetwork open;
  open.apply(insertion);
  return joining_vertices(mesh, joints, open, {});
}

}  // namespace

Insertion first_insertion(const Mesh& mesh, const Joints& joints, const Case& run_case) {
  Insertion insertion;
  for (VertexIndex v = 0; v < mesh.vertices.size(); ++v) {
    const auto& units = mesh.vertices[v].units;
    const bool open = std::any_of(units.begin(), units.end(), [&](UnitIndex unit) {
      return joints.properties[unit].kind == FractureKind::open;
    });
    if (open) insertion.new_nodes.push_back(make_node(mesh, v, run_case, 0));
  }
  for (const VertexIndex v : touched_by(mesh, joints, insertion))
    insertion.new_nodes.push_back(make_node(mesh, v, run_case, 0));
  if (insertion.new_nodes.empty() && !run_case.injection.perforations.empty())
    throw InputError("no open fracture has a mesh vertex inside it: lengthen it or lower mesh.fracture_size");
  for (const Perforation& perforation : run_case.injection.perforations) {
    const VertexIndex vertex = nearest_split_vertex(mesh, perforation.position);
    const bool found = std::any_of(insertion.new_nodes.begin(), insertion.new_nodes.end(),
                                   [vertex](const NetworkNode& node) { return node.id == vertex; });
    if (!found)
      throw InputError(fmt::format("perforation {} at ({}, {}) m does not lie inside an open fracture",
                                   perforation.name, perforation.position[0], perforation.position[1]));
    insertion.new_perforations.push_back({perforation.name, vertex});
  }
  connect_nodes(mesh, FractureNetwork(), run_case, insertion);
  return insertion;
}

Insertion connect(const Mesh& mesh, const FractureNetwork& network, const std::vector<VertexIndex>& vertices,
                  const Case& run_case, double time) {
  Insertion insertion;
  insertion.revision = network.revision() + 1;
  for (const VertexIndex vertex : vertices)
    insertion.new_nodes.push_back(make_node(mesh, vertex, run_case, time));
  connect_nodes(mesh, network, run_case, insertion);
  return insertion;
}

}  // namespace fissura::structure
