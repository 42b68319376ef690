// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/fracture_tips.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

std::vector<FractureTip> fracture_tips(const Mesh& mesh) {
  std::vector<std::uint32_t> edges_at(mesh.vertices.size(), 0);
  for (const FractureEdge& edge : mesh.edges) {
    ++edges_at[edge.begin];
    ++edges_at[edge.end];
  }
  std::vector<FractureTip> tips;
  for (const FractureEdge& edge : mesh.edges) {
    if (mesh.lines[edge.line].kind == FractureKind::natural) continue;
    for (const auto& [at, from] : {std::pair{edge.begin, edge.end}, std::pair{edge.end, edge.begin}}) {
      if (edges_at[at] != 1 || !mesh.vertices[at].units.empty()) continue;
      const Point p = mesh.vertices[at].position, q = mesh.vertices[from].position;
      const double length = std::hypot(p[0] - q[0], p[1] - q[1]);
      tips.push_back({at, from, mesh.vertices[at].node, edge.line, p, {(p[0] - q[0]) / length, (p[1] - q[1]) / length}});
    }
  }
  std::sort(tips.begin(), tips.end(), [](const FractureTip& a, const FractureTip& b) { return a.vertex < b.vertex; });
  return tips;
}

double adjacent_pressure(const Mesh& mesh, const Joints& joints, const FractureTip& tip) {
  double pressure = 0;
  for (const UnitIndex unit : mesh.vertices[tip.previous].units)
    pressure = std::max(pressure, joints.state[unit].pressure);
  return pressure;
}

}  // namespace fissura::structure
