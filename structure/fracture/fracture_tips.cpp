// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/fracture_tips.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fissura::structure {

namespace {

constexpr int places_behind_tip = 4;
constexpr double open_natural_faces =
    5e-6;  // opening from which the fluid in a natural fracture pushes its end apart [m]

/// One end of an edge, on the way back from a tip.
struct Place {
  EdgeIndex edge = 0;
  VertexIndex vertex = 0;
};

std::array<double, 2> unit_vector(const Point& from, const Point& to) {
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  return {(to[0] - from[0]) / length, (to[1] - from[1]) / length};
}

FractureTip tip_at_end(const Mesh& mesh, EdgeIndex edge, VertexIndex vertex, FractureTip::Kind kind) {
  const VertexIndex previous = mesh.edges[edge].across(vertex);
  const Point &at = mesh.vertices[vertex].position, &from = mesh.vertices[previous].position;
  return {kind,
          vertex,
          previous,
          edge,
          mesh.vertices[vertex].node,
          mesh.edges[edge].line,
          at,
          unit_vector(from, at)};
}

/// Calls `visit(edge, vertex)` at every end of a fracture inside the rock.
template <class Visit>
void visit_ends(const Mesh& mesh, const Visit& visit) {
  for (VertexIndex vertex = 0; vertex < mesh.vertices.size(); ++vertex)
    if (mesh.vertices[vertex].edges.size() == 1 && mesh.vertices[vertex].units.empty())
      visit(mesh.vertices[vertex].edges.front(), vertex);
}

double open_pressure(const Mesh& mesh, const Joints& joints, const Place& place) {
  const UnitIndex unit = mesh.edges[place.edge].unit_at(place.vertex);
  if (unit == no_unit || joints.state[unit].closed) return 0;
  if (joints.properties[unit].kind == FractureKind::natural &&
      joints.state[unit].opening < open_natural_faces)
    return 0;
  return joints.state[unit].pressure;
}

/// The edge that goes on beyond `vertex`; nothing at an end or a junction.
std::optional<EdgeIndex> edge_beyond(const Mesh& mesh, EdgeIndex edge, VertexIndex vertex) {
  const auto& edges = mesh.vertices[vertex].edges;
  if (edges.size() != 2) return std::nullopt;
  return edges.front() == edge ? edges.back() : edges.front();
}

bool active(const Mesh& mesh, const Joints& joints, EdgeIndex edge, VertexIndex end) {
  const UnitIndex unit = mesh.edges[edge].unit_at(mesh.edges[edge].across(end));
  if (unit == no_unit) return false;
  const JointState& state = joints.state[unit];
  return state.slip > active_slip || !state.closed;
}

}  // namespace

std::vector<FractureTip> fracture_tips(const Mesh& mesh) {
  std::vector<FractureTip> tips;
  visit_ends(mesh, [&](EdgeIndex edge, VertexIndex vertex) {
    if (mesh.lines[mesh.edges[edge].line].kind == FractureKind::natural) return;
    tips.push_back(tip_at_end(mesh, edge, vertex, FractureTip::Kind::end));
  });
  return tips;
}

std::vector<FractureTip> natural_ends(const Mesh& mesh, const Joints& joints) {
  std::vector<FractureTip> tips;
  visit_ends(mesh, [&](EdgeIndex edge, VertexIndex vertex) {
    if (mesh.lines[mesh.edges[edge].line].kind != FractureKind::natural ||
        !active(mesh, joints, edge, vertex))
      return;
    tips.push_back(tip_at_end(mesh, edge, vertex, FractureTip::Kind::natural_end));
  });
  return tips;
}

double adjacent_pressure(const Mesh& mesh, const Joints& joints, const FractureTip& tip) {
  Place place{tip.edge, tip.kind == FractureTip::Kind::crossing ? tip.vertex : tip.previous};
  double least = open_pressure(mesh, joints, place);
  for (int k = 1; k < places_behind_tip && least > 0; ++k) {
    if (place.vertex == tip.vertex) {
      place.vertex = tip.previous;
    } else {
      const auto beyond = edge_beyond(mesh, place.edge, place.vertex);
      if (!beyond) break;
      place = {*beyond, mesh.edges[*beyond].across(place.vertex)};
    }
    if (mesh.vertices[place.vertex].units.empty()) break;
    least = std::min(least, open_pressure(mesh, joints, place));
  }
  return least;
}

std::array<double, 2> mean_direction(const Mesh& mesh, const FractureTip& tip, int edges) {
  EdgeIndex edge = tip.edge;
  VertexIndex from = tip.previous;
  for (int k = 1; k < edges; ++k) {
    const auto beyond = edge_beyond(mesh, edge, from);
    if (!beyond) break;
    edge = *beyond;
    from = mesh.edges[edge].across(from);
  }
  return unit_vector(mesh.vertices[from].position, tip.position);
}

}  // namespace fissura::structure
