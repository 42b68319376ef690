// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/local_stress.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

namespace {

constexpr double reach = 6, clearance = 2;  // in h
constexpr int parts = 4;
constexpr std::size_t fewest = 12;  // elements, for three unknowns

double plane_strain_modulus(const Elasticity& moduli) {
  return 4 * moduli.shear * (moduli.lame + moduli.shear) / (moduli.lame + 2 * moduli.shear);
}

/// Jump at one end of an edge, left-hand side of the edge relative to the right-hand side.
std::array<double, 2> jump_at(const Mesh& mesh, const std::vector<double>& displacement,
                              const FractureEdge& edge, VertexIndex vertex) {
  const UnitIndex index = edge.unit_at(vertex);
  if (index == no_unit) return {0, 0};
  const ContactUnit& unit = mesh.units[index];
  const Point &begin = mesh.vertices[edge.begin].position, &end = mesh.vertices[edge.end].position;
  const double along = unit.face[1] * (end[0] - begin[0]) - unit.face[0] * (end[1] - begin[1]);
  const NodeIndex left = along > 0 ? unit.plus : unit.minus, right = along > 0 ? unit.minus : unit.plus;
  return {displacement[2 * left] - displacement[2 * right],
          displacement[2 * left + 1] - displacement[2 * right + 1]};
}

struct Sample {
  double area = 0, x = 0, y = 0;  // from the place
  InPlane<double> stress{};
};

InPlane<double> fit(const std::vector<Sample>& samples) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
  for (const Sample& sample : samples) {
    const Eigen::Vector3d terms(1, sample.x, sample.y);
    normal += sample.area * terms * terms.transpose();
    right += sample.area * terms * Eigen::RowVector3d(sample.stress.xx, sample.stress.yy, sample.stress.xy);
  }
  const Eigen::Matrix3d plane = normal.colPivHouseholderQr().solve(right);
  return {plane(0, 0), plane(0, 1), plane(0, 2)};
}

InPlane<double> in_situ_total(const InSituElement& element) {
  return {element.xx - element.pore_pressure, element.yy - element.pore_pressure, element.xy};
}

}  // namespace

std::vector<DisplacementJump> jumps_of_fracture(const Mesh& mesh, const std::vector<double>& displacement,
                                                VertexIndex vertex) {
  std::vector<bool> seen(mesh.vertices.size(), false);
  std::vector<VertexIndex> front{vertex};
  std::vector<EdgeIndex> edges;
  seen[vertex] = true;
  while (!front.empty()) {
    const VertexIndex at = front.back();
    front.pop_back();
    for (const EdgeIndex index : mesh.vertices[at].edges) {
      const FractureEdge& edge = mesh.edges[index];
      if (mesh.lines[edge.line].kind == FractureKind::natural) continue;
      edges.push_back(index);
      if (const VertexIndex next = edge.across(at); !seen[next]) {
        seen[next] = true;
        front.push_back(next);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<DisplacementJump> jumps;
  for (const EdgeIndex index : edges) {
    const FractureEdge& edge = mesh.edges[index];
    jumps.push_back({mesh.vertices[edge.begin].position, mesh.vertices[edge.end].position,
                     jump_at(mesh, displacement, edge, edge.begin),
                     jump_at(mesh, displacement, edge, edge.end)});
  }
  return jumps;
}

InPlane<double> local_stress(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                             const std::vector<double>& displacement, const MeetingPlace& place) {
  const std::vector<DisplacementJump> jumps = jumps_of_fracture(mesh, displacement, place.tip);
  const double modulus = plane_strain_modulus(moduli);
  std::vector<Sample> samples;
  ElementIndex nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Point at = centroid(mesh, element);
    const double x = at[0] - place.centre[0], y = at[1] - place.centre[1], distance = std::hypot(x, y);
    if (distance < least) {
      least = distance;
      nearest = element;
    }
    if (distance > reach * place.h) continue;
    if (std::any_of(jumps.begin(), jumps.end(), [&](const DisplacementJump& jump) {
          return distance_to_segment(at, jump.begin, jump.end) < clearance * place.h;
        }))
      continue;
    const double pressure = body.in_situ[element].pore_pressure;
    InPlane<double> stress = undamaged_stress(mesh, body, moduli, element, displacement).in_plane;
    stress.xx -= pressure;
    stress.yy -= pressure;
    for (const DisplacementJump& jump : jumps) {
      const InPlane<double> own = stress_of_jump(jump, parts, modulus, at);
      stress.xx -= own.xx;
      stress.yy -= own.yy;
      stress.xy -= own.xy;
    }
    samples.push_back({triangle(mesh, element).area, x, y, stress});
  }
  return samples.size() < fewest ? in_situ_total(body.in_situ[nearest]) : fit(samples);
}

}  // namespace fissura::structure
