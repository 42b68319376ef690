// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/hand_over.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/log.hpp"
#include "structure/dynamics/damage_transfer.hpp"
#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/patch_equilibrium.hpp"
#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

namespace {

// In units of tip_size.
constexpr double looked_at_around_vertex = 0.75;
constexpr double healed_aside = 1.2;
constexpr double moved_aside = 3;
constexpr double gap_filled_from = 1;
constexpr double not_healed_before_tip = 0.75;

constexpr int rounds = 8;
constexpr double noticed = 1e-3;  // share of strength lost

struct Station {
  double distance = std::numeric_limits<double>::infinity();  // from the line [m]
  double along = 0;                                           // from its begin [m]
};

Station station(const Point& at, const std::vector<Point>& line) {
  Station nearest;
  double begin = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double dx = line[k + 1][0] - line[k][0], dy = line[k + 1][1] - line[k][1],
                 length = std::hypot(dx, dy);
    const double distance = distance_to_segment(at, line[k], line[k + 1]);
    if (distance < nearest.distance) {
      const double share = ((at[0] - line[k][0]) * dx + (at[1] - line[k][1]) * dy) / (length * length);
      nearest = {distance, begin + std::clamp(share, 0.0, 1.0) * length};
    }
    begin += length;
  }
  return nearest;
}

double length_of(const std::vector<Point>& line) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    length += std::hypot(line[k + 1][0] - line[k][0], line[k + 1][1] - line[k][1]);
  return length;
}

bool contains(const std::vector<VertexIndex>& list, VertexIndex vertex) {
  return std::find(list.begin(), list.end(), vertex) != list.end();
}

}  // namespace

HandOver::HandOver(const GrowthPlan& plan, const StructureModel& model, const Geometry& geometry,
                   const StructureState& state)
    : plan_(plan), h_(model.run_case.mesh.tip_size) {
  const Mesh& mesh = geometry.mesh;
  const FailureMap map(model, geometry, state);
  std::vector<FractureVertex> vertices = mesh.vertices;
  std::vector<ElementIndex> removed;
  for (const PatchPlan& patch : plan.patches) {
    vertices.insert(vertices.end(), patch.new_vertices.begin(), patch.new_vertices.end());
    Line& line = lines_.emplace_back();
    line.points.push_back(vertices[patch.new_edges.front().begin].position);
    for (const FractureEdge& edge : patch.new_edges) line.points.push_back(vertices[edge.end].position);
    line.begins_at_tip = !contains(patch.split, patch.new_edges.front().begin);
    line.ends_at_tip = !contains(patch.split, patch.new_edges.back().end);
    for (const VertexIndex vertex : patch.split)
      line.lost.emplace_back(vertex, map.greatest_near(mesh, patch.removed, vertices[vertex].position,
                                                       looked_at_around_vertex * h_));
    const std::vector<NodeIndex> inner = inner_nodes(mesh, geometry.node_elements, patch.removed);
    moved_nodes_.insert(moved_nodes_.end(), inner.begin(), inner.end());
    removed.insert(removed.end(), patch.removed.begin(), patch.removed.end());
  }
  std::sort(moved_nodes_.begin(), moved_nodes_.end());
  std::sort(removed.begin(), removed.end());
  for (const ElementDamage& record : damage_records(geometry.tiles, state.body.damage))
    if (std::binary_search(removed.begin(), removed.end(), record.element))
      removed_.push_back({centroid(mesh, record.element), record});
}

bool HandOver::healed(const Point& at) const {
  return std::any_of(lines_.begin(), lines_.end(), [&](const Line& line) {
    const Station seen = station(at, line.points);
    const double first = line.begins_at_tip ? not_healed_before_tip * h_ : 0,
                 last = length_of(line.points) - (line.ends_at_tip ? not_healed_before_tip * h_ : 0);
    return seen.distance < healed_aside * h_ && seen.along >= first && seen.along <= last;
  });
}

bool HandOver::follow_opening(const StructureModel& model, const Geometry& geometry,
                              const std::vector<ElementIndex>& elements,
                              const std::vector<double>& displacement,
                              std::vector<ElementDamage>& records) const {
  const Mesh& mesh = geometry.mesh;
  const RockFailure law = rock_failure(model.run_case.rock, model.run_case.bulk_failure);
  const std::size_t before = records.size();
  bool changed = false;
  for (const ElementIndex element : elements) {
    const Point at = centroid(mesh, element);
    const PlaneStrainStress stress =
        undamaged_stress(mesh, geometry.body, model.moduli, element, displacement);
    const auto end = records.begin() + static_cast<std::ptrdiff_t>(before);
    const auto known = std::lower_bound(records.begin(), end, element,
                                        [](const ElementDamage& a, ElementIndex b) { return a.element < b; });
    if (known != end && known->element == element) {
      const double lost = lost_strength(law.tension, known->history);
      const PlaneStrainStress elastic = without_plastic_part(model.moduli, stress, known->plastic);
      grow_damage(law.tension, principal(elastic.in_plane).major / law.tension.band_modulus, known->history);
      changed = changed || lost_strength(law.tension, known->history) > lost + noticed;
      continue;
    }
    const auto& [a, b, c] = mesh.elements[element];
    if (healed(at) || !failure_onset(law, stress, {mesh.position[a], mesh.position[b], mesh.position[c]}))
      continue;
    const Removed* most = nullptr;
    for (const Removed& candidate : removed_)
      if (std::hypot(candidate.centroid[0] - at[0], candidate.centroid[1] - at[1]) < gap_filled_from * h_ &&
          (!most || lost_strength(law.tension, candidate.record.history) >
                        lost_strength(law.tension, most->record.history)))
        most = &candidate;
    if (most) records.push_back(record_on(most->record, mesh, element, law));
  }
  std::sort(records.begin(), records.end(),
            [](const ElementDamage& a, const ElementDamage& b) { return a.element < b.element; });
  return changed || records.size() > before;
}

void HandOver::carry_out(const MeshInsertion& insertion, const StructureModel& model,
                         const Geometry& geometry, std::vector<ElementDamage> records,
                         StructureState& state) const {
  const Mesh& mesh = geometry.mesh;
  const auto& made = insertion.change.made;
  std::erase_if(records, [&](const ElementDamage& record) {
    return std::binary_search(made.begin(), made.end(), record.element) &&
           healed(centroid(mesh, record.element));
  });

  const auto& fresh = insertion.change.new_units;
  for (const Line& line : lines_)
    for (const auto& [vertex, lost] : line.lost)
      for (const UnitIndex unit : mesh.vertices[vertex].units)
        if (std::binary_search(fresh.begin(), fresh.end(), unit)) {
          double& separation = state.joints.state[unit].greatest_separation;
          separation = std::max(separation, lost * state.joints.properties[unit].cohesive.critical_opening());
        }

  std::vector<ElementIndex> around;
  for (const ElementIndex element : made)
    if (std::any_of(lines_.begin(), lines_.end(), [&](const Line& line) {
          return station(centroid(mesh, element), line.points).distance < moved_aside * h_;
        }))
      around.push_back(element);
  PatchEquilibriumReport report;
  for (int round = 0; round < rounds; ++round) {
    report = equilibrate(model, geometry, around, records, state.joints, state.body.displacement);
    if (!follow_opening(model, geometry, around, state.body.displacement, records)) break;
  }
  if (!report.converged)
    log::warn(fmt::format(
        "a failed band is handed over to the faces of a fracture out of equilibrium: {:.2g} of the "
        "displacement is left after {} iterations",
        report.residual, report.iterations));
  const auto& u = state.body.displacement;
  for (const UnitIndex index : fresh) {
    const ContactUnit& unit = mesh.units[index];
    JointState& joint = state.joints.state[index];
    const double length = std::hypot(unit.face[0], unit.face[1]), nx = unit.face[0] / length,
                 ny = unit.face[1] / length;
    const double dx = u[2 * std::size_t{unit.plus}] - u[2 * std::size_t{unit.minus}],
                 dy = u[2 * std::size_t{unit.plus} + 1] - u[2 * std::size_t{unit.minus} + 1];
    joint.opening = dx * nx + dy * ny;
    joint.sliding = dx * ny - dy * nx;
    joint.greatest_separation =
        std::max(joint.greatest_separation, std::hypot(std::max(joint.opening, 0.0), joint.sliding));
    joint.closed = joint.opening <= 0;
  }
  state.body.damage = damage_from_records(geometry.tiles, records);
}

}  // namespace fissura::structure
