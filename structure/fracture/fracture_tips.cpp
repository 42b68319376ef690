// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/fracture_tips.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

namespace {

constexpr int vertices_behind_tip = 4;

double open_pressure(const Mesh& mesh, const Joints& joints, VertexIndex vertex) {
  double pressure = 0;
  for (const UnitIndex unit : mesh.vertices[vertex].units)
    if (!joints.state[unit].closed) pressure = std::max(pressure, joints.state[unit].pressure);
  return pressure;
}

std::vector<VertexIndex> neighbours(const Mesh& mesh, VertexIndex vertex, VertexIndex except) {
  std::vector<VertexIndex> found;
  for (const EdgeIndex edge : mesh.vertices[vertex].edges)
    if (const VertexIndex other = mesh.edges[edge].across(vertex); other != except) found.push_back(other);
  return found;
}

}  // namespace

std::vector<FractureTip> fracture_tips(const Mesh& mesh) {
  std::vector<FractureTip> tips;
  for (const FractureEdge& edge : mesh.edges) {
    if (mesh.lines[edge.line].kind == FractureKind::natural) continue;
    for (const auto& [at, from] : {std::pair{edge.begin, edge.end}, std::pair{edge.end, edge.begin}}) {
      if (mesh.vertices[at].edges.size() != 1 || !mesh.vertices[at].units.empty()) continue;
      const Point p = mesh.vertices[at].position, q = mesh.vertices[from].position;
      const double length = std::hypot(p[0] - q[0], p[1] - q[1]);
      tips.push_back({at, from, mesh.vertices[at].node, edge.line, p, {(p[0] - q[0]) / length, (p[1] - q[1]) / length}});
    }
  }
  std::sort(tips.begin(), tips.end(), [](const FractureTip& a, const FractureTip& b) { return a.vertex < b.vertex; });
  return tips;
}

double adjacent_pressure(const Mesh& mesh, const Joints& joints, const FractureTip& tip) {
  double least = open_pressure(mesh, joints, tip.previous);
  VertexIndex from = tip.vertex, at = tip.previous;
  for (int k = 1; k < vertices_behind_tip && least > 0; ++k) {
    const std::vector<VertexIndex> beyond = neighbours(mesh, at, from);
    if (beyond.size() != 1 || mesh.vertices[beyond.front()].units.empty()) break;
    from = at;
    at = beyond.front();
    least = std::min(least, open_pressure(mesh, joints, at));
  }
  return least;
}

}  // namespace fissura::structure
