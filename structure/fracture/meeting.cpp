// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/meeting.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/case/names.hpp"
#include "structure/fracture/local_stress.hpp"

namespace fissura::structure {

namespace {

constexpr int edges_of_mean_direction = 10;

std::array<double, 2> edge_direction(const Mesh& mesh, EdgeIndex index) {
  const FractureEdge& edge = mesh.edges[index];
  const Point &a = mesh.vertices[edge.begin].position, &b = mesh.vertices[edge.end].position;
  return {(b[0] - a[0]) / edge.length, (b[1] - a[1]) / edge.length};
}

double remaining_cement(const RockNow& rock, EdgeIndex edge, VertexIndex vertex) {
  const UnitIndex unit = rock.geometry.mesh.edges[edge].unit_at(vertex);
  if (unit == no_unit) return rock.geometry.mesh.lines[rock.geometry.mesh.edges[edge].line].tensile_strength;
  const Joints& joints = rock.state.joints;
  return joints.properties[unit].cohesive.envelope(joints.state[unit].greatest_separation);
}

/// How far the friction of the fracture lies above what a crossing needs; infinite if any is enough.
double margin(const Meeting& meeting) {
  if (!meeting.verdict.crosses && !meeting.verdict.critical_friction) return -INFINITY;
  return meeting.verdict.critical_friction ? meeting.friction - *meeting.verdict.critical_friction : INFINITY;
}

/// Node at `vertex` of the elements into which `direction` leads from there.
std::optional<NodeIndex> node_towards(const Geometry& geometry, VertexIndex vertex,
                                      const std::array<double, 2>& direction) {
  const Mesh& mesh = geometry.mesh;
  std::vector<NodeIndex> nodes{mesh.vertices[vertex].node};
  for (const UnitIndex unit : mesh.vertices[vertex].units)
    nodes.insert(nodes.end(), {mesh.units[unit].minus, mesh.units[unit].plus});
  const Point& at = mesh.vertices[vertex].position;
  const auto left_of = [&](const Point& p, double sign) {
    return sign * ((p[0] - at[0]) * direction[1] - (p[1] - at[1]) * direction[0]) >= 0;
  };
  for (const NodeIndex node : nodes)
    for (const ElementIndex element : geometry.node_elements.of(node)) {
      const auto& corners = mesh.elements[element];
      const auto here =
          static_cast<std::size_t>(std::find(corners.begin(), corners.end(), node) - corners.begin());
      const Point &next = mesh.position[corners[(here + 1) % 3]],
                  &last = mesh.position[corners[(here + 2) % 3]];
      if (left_of(next, 1) && left_of(last, -1)) return node;
    }
  return std::nullopt;
}

}  // namespace

std::optional<Meeting> meet(const RockNow& rock, const FractureTip& tip, const SegmentEnd& end, double time) {
  const Mesh& mesh = rock.geometry.mesh;
  const Case& given = rock.model.run_case;
  if (end.kind != SegmentEnd::Kind::fracture) return std::nullopt;
  std::optional<Meeting> decisive;
  const std::array<double, 2> direction = mean_direction(mesh, tip, edges_of_mean_direction);
  for (const EdgeIndex edge : mesh.vertices[end.vertex].edges) {
    const FractureLine& line = mesh.lines[mesh.edges[edge].line];
    if (line.kind != FractureKind::natural) continue;
    Meeting meeting;
    meeting.time = time;
    meeting.position = end.position;
    meeting.hydraulic = mesh.lines[tip.line].name;
    meeting.natural = line.name;
    meeting.stress = local_stress(mesh, rock.geometry.body, rock.model.moduli, rock.state.body.displacement,
                                  {end.position, tip.vertex, given.mesh.tip_size});
    const double pore = pore_pressure(given.in_situ, end.position);
    meeting.stress.xx += pore;
    meeting.stress.yy += pore;
    meeting.friction = line.friction_coefficient;
    meeting.cohesion = line.cohesion + remaining_cement(rock, edge, end.vertex);
    meeting.strength = given.rock.tensile_strength;
    meeting.rule = given.growth.crossing;
    meeting.verdict = crossing_verdict(meeting.rule, {direction, edge_direction(mesh, edge), meeting.stress,
                                                      meeting.friction, meeting.cohesion, meeting.strength});
    meeting.junction = end.vertex;
    meeting.direction = direction;
    if (!decisive || margin(meeting) < margin(*decisive)) decisive = meeting;
  }
  return decisive;
}

std::vector<FractureTip> crossing_tips(const Geometry& geometry, const std::vector<CrossingSeed>& seeds) {
  const Mesh& mesh = geometry.mesh;
  std::vector<FractureTip> tips;
  for (const CrossingSeed& seed : seeds) {
    const auto node = node_towards(geometry, seed.vertex, seed.direction);
    if (!node) continue;
    const FractureEdge& edge = mesh.edges[seed.edge];
    tips.push_back({FractureTip::Kind::crossing, seed.vertex, edge.across(seed.vertex), seed.edge, *node,
                    edge.line, mesh.vertices[seed.vertex].position, seed.direction});
  }
  return tips;
}

nlohmann::json meetings_json(const std::vector<Meeting>& meetings) {
  nlohmann::json list = nlohmann::json::array();
  for (const Meeting& m : meetings) {
    nlohmann::json entry{{"time", m.time},
                         {"x", m.position[0]},
                         {"y", m.position[1]},
                         {"hydraulic", m.hydraulic},
                         {"natural", m.natural},
                         {"angle", m.verdict.angle},
                         {"stress_xx", m.stress.xx},
                         {"stress_yy", m.stress.yy},
                         {"stress_xy", m.stress.xy},
                         {"friction", m.friction},
                         {"cohesion", m.cohesion},
                         {"strength", m.strength},
                         {"criterion", name_of(m.rule, crossing_rules)},
                         {"critical_friction", nullptr},
                         {"crosses", m.verdict.crosses}};
    if (m.verdict.critical_friction) entry["critical_friction"] = *m.verdict.critical_friction;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace fissura::structure
