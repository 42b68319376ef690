// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/growth.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "structure/dynamics/damage_transfer.hpp"
#include "structure/dynamics/energy.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/dynamics/untouched_hash.hpp"
#include "structure/fracture/connected_elements.hpp"
#include "structure/fracture/hand_over.hpp"
#include "structure/fracture/state_transfer.hpp"
#include "structure/joints/network_topology.hpp"

namespace fissura::structure {

namespace {

using Clock = std::chrono::steady_clock;

bool joins_network(const GrowthPlan& plan, VertexIndex vertex) {
  const auto& joining = plan.insertion.new_nodes;
  return std::any_of(joining.begin(), joining.end(),
                     [&](const NetworkNode& node) { return vertex_of(node.id) == vertex; });
}

bool on_natural_fracture(const Mesh& mesh, const Joints& joints, VertexIndex vertex) {
  const auto& units = mesh.vertices[vertex].units;
  return std::any_of(units.begin(), units.end(), [&](UnitIndex unit) {
    return unit < joints.properties.size() && joints.properties[unit].kind == FractureKind::natural;
  });
}

// Fresh faces are dry where the fluid of the network will reach them. Elsewhere, and where a natural fracture
// is met, pore fluid fills them.
double pressure_on_fresh_faces(const GrowthPlan& plan, const Geometry& geometry, const Case& run_case,
                               const Joints& joints, VertexIndex vertex) {
  const bool reached = geometry.network.contains(vertex) || joins_network(plan, vertex);
  if (reached && !on_natural_fracture(geometry.mesh, joints, vertex)) return 0;
  return pore_pressure(run_case.in_situ, geometry.mesh.vertices[vertex].position);
}

// A unit that is a part of an older one starts with all it knew; the others are fresh breaks of the rock.
void extend_joints(const GrowthPlan& plan, const MeshInsertion& insertion, const Geometry& geometry,
                   const Case& run_case, Joints& joints) {
  UnitIndex next = insertion.change.new_units.empty() ? 0 : insertion.change.new_units.front();
  for (const PatchPlan& patch : plan.patches)
    for (const PlannedUnit& planned : patch.units) {
      if (planned.same) continue;
      if (planned.source) {
        const UnitIndex source = *planned.source;
        joints.properties.push_back(joints.properties[source]);
        joints.state.push_back(joints.state[source]);
        joints.ramp.push_back(joints.ramp[source]);
      } else {
        const double pressure = pressure_on_fresh_faces(plan, geometry, run_case, joints, planned.vertex);
        joints.properties.push_back(joint_properties(geometry.mesh, next, run_case.rock));
        joints.state.emplace_back().pressure = pressure;
        joints.ramp.push_back({pressure, pressure, 0, 0, 0});
      }
      joints.released.push_back(1);
      ++next;
    }
}

// A seed is spent where a segment begins, and where another fracture comes out on the far side.
void follow_crossing_seeds(const GrowthPlan& plan, const Mesh& mesh, std::vector<CrossingSeed>& seeds) {
  for (const PatchPlan& patch : plan.patches)
    std::erase_if(seeds, [&](const CrossingSeed& seed) {
      return seed.vertex == patch.new_edges.front().begin || seed.vertex == patch.new_edges.back().end;
    });
  for (std::size_t k = 0; k < plan.meetings.size(); ++k) {
    const Meeting& meeting = plan.meetings[k];
    if (!meeting.verdict.crosses) continue;
    EdgeIndex last = static_cast<EdgeIndex>(mesh.edges.size() - 1);
    for (std::size_t later = plan.patches.size() - 1; later > plan.meeting_patch[k]; --later)
      last -= static_cast<EdgeIndex>(plan.patches[later].new_edges.size());
    seeds.push_back({meeting.junction, last, meeting.direction});
  }
}

std::vector<ElementIndex> removed_elements(const GrowthPlan& plan) {
  std::vector<ElementIndex> removed;
  for (const PatchPlan& patch : plan.patches)
    removed.insert(removed.end(), patch.removed.begin(), patch.removed.end());
  std::sort(removed.begin(), removed.end());
  return removed;
}

void sort_without_repeats(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

Touched what_goes(const GrowthPlan& plan, const std::vector<NodeIndex>& moved_nodes) {
  Touched touched{removed_elements(plan), moved_nodes};
  for (const PatchPlan& patch : plan.patches) {
    for (const Rewiring& rewiring : patch.rewired) touched.elements.push_back(rewiring.element);
    touched.nodes.insert(touched.nodes.end(), patch.unused.begin(), patch.unused.end());
  }
  sort_without_repeats(touched.elements);
  sort_without_repeats(touched.nodes);
  return touched;
}

Touched what_came(const MeshChange& change, const std::vector<NodeIndex>& moved_nodes) {
  Touched touched{change.made, change.new_nodes};
  touched.elements.insert(touched.elements.end(), change.rewired.begin(), change.rewired.end());
  touched.nodes.insert(touched.nodes.end(), moved_nodes.begin(), moved_nodes.end());
  std::sort(touched.elements.begin(), touched.elements.end());
  sort_without_repeats(touched.nodes);
  return touched;
}

std::string hash_of_the_rest(const Geometry& geometry, const StructureState& state, const Touched& touched) {
  return untouched_hash(geometry.mesh, geometry.body, state.body.displacement, state.body.velocity, touched);
}

// Elements that fail hand over to the faces where fractures form out of failed rock.
std::optional<HandOver> hand_over_of(const GrowthPlan& plan, const StructureModel& model,
                                     const Geometry& geometry, const StructureState& state) {
  if (!forms_from_failed_rock(model.run_case)) return std::nullopt;
  return HandOver(plan, model, geometry, state);
}

// Elastic energy of these elements (ascending), of those that fail what failure has left of it [J/m].
double stored_energy(const StructureModel& model, const Geometry& geometry, const StructureState& state,
                     const std::vector<ElementIndex>& elements) {
  const std::vector<double>& displacement = state.body.displacement;
  double energy = 0;
  for (const ElementIndex element : elements) {
    const Triangle shape = triangle(geometry.mesh, element);
    energy += shape.area *
              elastic_energy_density(model.moduli, strain(geometry.mesh, element, shape, displacement));
  }
  std::vector<ElementDamage> records = damage_records(geometry.tiles, state.body.damage);
  std::erase_if(records, [&](const ElementDamage& record) {
    return !std::binary_search(elements.begin(), elements.end(), record.element);
  });
  return energy - released_energy(geometry.mesh, geometry.body, model.moduli, displacement, records);
}

// On failure of the rock that exists and on the cohesion of the faces [J/m].
double work_spent(const StructureModel& model, const Geometry& geometry, const StructureState& state) {
  const Case& given = model.run_case;
  if (!given.bulk_failure.active) return 0;
  return failure_dissipation(geometry.mesh, rock_failure(given.rock, given.bulk_failure),
                             damage_records(geometry.tiles, state.body.damage)) +
         cohesive_work(geometry.mesh, state.joints);
}

}  // namespace

std::vector<ElementIndex> tip_surroundings(const StructureModel& model, const Geometry& geometry,
                                           const Joints& joints) {
  const double radius = model.run_case.bulk_failure.tip_exclusion * model.run_case.mesh.tip_size;
  const Mesh& mesh = geometry.mesh;
  std::vector<ElementIndex> elements;
  const auto add_around = [&](NodeIndex node) {
    const auto near = connected_elements(mesh, geometry.node_elements, node, mesh.position[node], radius);
    elements.insert(elements.end(), near.begin(), near.end());
  };
  for (const FractureTip& tip : fracture_tips(mesh)) add_around(tip.node);
  for (const FractureTip& tip : natural_ends(mesh, joints)) add_around(tip.node);
  for (UnitIndex unit = 0; unit < mesh.units.size(); ++unit) {
    if (joints.properties[unit].cohesive.strength == 0 || joints.broken(unit)) continue;
    add_around(mesh.units[unit].minus);
    add_around(mesh.units[unit].plus);
  }
  sort_without_repeats(elements);
  return elements;
}

EntitiesThatChange entities_that_change(const GrowthPlan& plan) {
  EntitiesThatChange changing{{}, removed_elements(plan)};
  for (const PatchPlan& patch : plan.patches)
    for (const PlannedUnit& unit : patch.units) {
      if (unit.same) changing.units.push_back(*unit.same);
      if (unit.source) changing.units.push_back(*unit.source);
    }
  sort_without_repeats(changing.units);
  return changing;
}

std::vector<RemeshRecord> grow(const GrowthPlan& plan, const StructureModel& model, Geometry& geometry,
                               StructureState& state) {
  const Clock::time_point start = Clock::now();
  const double thickness = model.run_case.domain.thickness;
  RemeshRecord common;
  common.stable_step_before = stable_step(model, geometry, state);
  const StateTransfer transfer(plan, geometry, state);
  const std::optional<HandOver> hand_over = hand_over_of(plan, model, geometry, state);
  const std::vector<NodeIndex> moved_nodes = hand_over ? hand_over->moved_nodes() : std::vector<NodeIndex>{};
  const double stored_before = stored_energy(model, geometry, state, removed_elements(plan));
  const double spent_before = work_spent(model, geometry, state);
  common.hash_before = hash_of_the_rest(geometry, state, what_goes(plan, moved_nodes));
  const DamageBefore damage =
      damage_before_change(geometry.mesh, geometry.tiles, state.body.damage, removed_elements(plan));

  state.sources.leave(observed_rock(model, geometry, state), entities_that_change(plan));
  const MeshInsertion insertion = insert_into_mesh(plan, geometry.mesh);
  follow(model, insertion.change, geometry);
  state.sources.follow(insertion.change);
  extend_joints(plan, insertion, geometry, model.run_case, state.joints);
  follow_crossing_seeds(plan, geometry.mesh, state.crossing_seeds);
  const TransferBalance balance = transfer.carry_over(insertion, geometry, state);
  if (model.run_case.bulk_failure.active) {
    const RockFailure law = rock_failure(model.run_case.rock, model.run_case.bulk_failure);
    std::vector<ElementDamage> records = carry_damage(damage, insertion.change, geometry.mesh, law);
    if (hand_over)
      hand_over->carry_out(insertion, model, geometry, std::move(records), state);
    else
      state.body.damage = damage_from_records(geometry.tiles, records);
    state.failure_work_gone += spent_before - work_spent(model, geometry, state);
  }
  common.hash_after = hash_of_the_rest(geometry, state, what_came(insertion.change, moved_nodes));

  common.untouched =
      insertion.change.elements_before - insertion.change.removed.size() - insertion.change.rewired.size();
  common.stable_step_after = stable_step(model, geometry, state);
  common.strain_energy_before = thickness * stored_before;
  common.strain_energy_after = thickness * stored_energy(model, geometry, state, insertion.change.made);
  common.kinetic_energy_before = thickness * transfer.before().kinetic_energy;
  common.kinetic_energy_after = thickness * balance.kinetic_energy;
  common.mass_error = balance.mass_error;
  common.momentum_error = balance.momentum_error;
  common.wall_seconds = (plan.wall_seconds + std::chrono::duration<double>(Clock::now() - start).count()) /
                        static_cast<double>(plan.patches.size());

  std::vector<RemeshRecord> records;
  for (const PatchPlan& patch : plan.patches) {
    RemeshRecord record = common;
    record.fracture = geometry.mesh.lines[patch.new_edges.front().line].name;
    record.tip = patch.tip;
    record.removed = patch.removed.size();
    record.made = patch.made.size();
    record.smallest_angle = patch.smallest_angle;
    record.smallest_altitude = patch.smallest_altitude;
    records.push_back(record);
  }
  return records;
}

nlohmann::json remeshing_json(const std::vector<RemeshRecord>& records) {
  nlohmann::json list = nlohmann::json::array();
  for (const RemeshRecord& r : records)
    list.push_back({{"fracture", r.fracture},
                    {"x", r.tip[0]},
                    {"y", r.tip[1]},
                    {"elements_removed", r.removed},
                    {"elements_made", r.made},
                    {"elements_untouched", r.untouched},
                    {"hash_before", r.hash_before},
                    {"hash_after", r.hash_after},
                    {"smallest_angle", r.smallest_angle},
                    {"smallest_altitude", r.smallest_altitude},
                    {"stable_step_before", r.stable_step_before},
                    {"stable_step_after", r.stable_step_after},
                    {"strain_energy_before", r.strain_energy_before},
                    {"strain_energy_after", r.strain_energy_after},
                    {"kinetic_energy_before", r.kinetic_energy_before},
                    {"kinetic_energy_after", r.kinetic_energy_after},
                    {"mass_error", r.mass_error},
                    {"momentum_error", r.momentum_error},
                    {"wall_seconds", r.wall_seconds}});
  return list;
}

}  // namespace fissura::structure
