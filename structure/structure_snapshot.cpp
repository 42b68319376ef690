// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "common/byte_archive.hpp"
#include "common/case/case_hash.hpp"
#include "common/fracture_network/insertion_archive.hpp"
#include "structure/geometry_archive.hpp"
#include "structure/joints/network_topology.hpp"
#include "structure/state_parts.hpp"

namespace fissura::structure {

namespace {

constexpr std::uint64_t format = 7;

void save_history(const StructureHistory& history, ByteWriter& bytes) {
  bytes.put(history.time);
  bytes.put(history.steps);
  bytes.put(history.insertions);
  bytes.put(history.equilibration.steps);
  bytes.put(history.equilibration.greatest_slip);
  bytes.put(history.equilibration.fracture);
  bytes.put(history.reported_geometry);
}

StructureHistory restore_history(ByteReader& bytes) {
  StructureHistory history;
  bytes.get(history.time);
  bytes.get(history.steps);
  bytes.get(history.insertions);
  bytes.get(history.equilibration.steps);
  bytes.get(history.equilibration.greatest_slip);
  bytes.get(history.equilibration.fracture);
  bytes.get(history.reported_geometry);
  return history;
}

void require(bool holds) {
  ByteReader::require(holds);
}

bool ascending(const std::vector<ElementIndex>& elements) {
  return std::adjacent_find(elements.begin(), elements.end(), std::greater_equal<>()) == elements.end();
}

void require_elements(const std::vector<ElementIndex>& elements, const Mesh& mesh) {
  require(ascending(elements) && (elements.empty() || elements.back() < mesh.elements.size()));
}

void save_damage(const Tiles& tiles, const Damage& damage, ByteWriter& bytes) {
  bytes.put(damage_records(tiles, damage));
  bytes.put(elements_without_onset(tiles, damage));
}

void restore_damage(const Geometry& geometry, ByteReader& bytes, Damage& damage) {
  std::vector<ElementDamage> records;
  std::vector<ElementIndex> without_onset, failed;
  bytes.get(records);
  bytes.get(without_onset);
  for (const ElementDamage& record : records) failed.push_back(record.element);
  for (const auto* elements : {&failed, &without_onset}) {
    require_elements(*elements, geometry.mesh);
    require(elements->empty() || !damage.empty());
  }
  if (damage.empty()) return;
  damage = damage_from_records(geometry.tiles, records);
  forbid_onset(geometry.tiles, without_onset, damage);
}

void save_joints(const Joints& joints, ByteWriter& bytes) {
  bytes.put(joints.properties);
  bytes.put(joints.state);
  bytes.put(joints.released);
  bytes.put(joints.ramp);
}

void restore_joints(const Mesh& mesh, ByteReader& bytes, Joints& joints) {
  bytes.get(joints.properties);
  bytes.get(joints.state);
  bytes.get(joints.released);
  bytes.get(joints.ramp);
  const std::size_t units = mesh.units.size();
  require(joints.properties.size() == units && joints.state.size() == units &&
          joints.released.size() == units && joints.ramp.size() == units);
}

void restore_motion(const Mesh& mesh, ByteReader& bytes, State& body) {
  bytes.get(body.displacement);
  bytes.get(body.velocity);
  const std::size_t degrees = 2 * mesh.position.size();
  require(body.displacement.size() == degrees && body.velocity.size() == degrees);
}

void restore_seeds(const Mesh& mesh, ByteReader& bytes, std::vector<CrossingSeed>& seeds) {
  bytes.get(seeds);
  for (const CrossingSeed& seed : seeds)
    require(seed.vertex < mesh.vertices.size() && seed.edge < mesh.edges.size());
}

/// Every node and segment of the network is a vertex with faces and an edge of the mesh.
void require_of_mesh(const FractureNetwork& network, const Mesh& mesh) {
  for (const NetworkNode& node : network.nodes())
    require(node.id < mesh.vertices.size() && !mesh.vertices[vertex_of(node.id)].units.empty());
  for (const NetworkSegment& segment : network.segments()) require(segment.id < mesh.edges.size());
}

Snapshot read_snapshot(ByteReader& reader, const StructureModel& model) {
  StructureHistory history = restore_history(reader);
  Geometry geometry = restore_geometry(reader);
  geometry.network = network_after(history.insertions);
  require_of_mesh(geometry.network, geometry.mesh);
  StructureState state = initial_state(model, geometry);
  std::vector<ElementIndex> wet;
  reader.get(wet);
  require_elements(wet, geometry.mesh);
  restore_motion(geometry.mesh, reader, state.body);
  restore_damage(geometry, reader, state.body.damage);
  restore_joints(geometry.mesh, reader, state.joints);
  state.mass_scaling.restore(reader);
  reader.get(state.failure_work_gone);
  restore_seeds(geometry.mesh, reader, state.crossing_seeds);
  state.sources.restore(reader);
  state.sources.require_of(observed_rock(model, geometry, state));
  reader.end();
  return {std::move(history), std::move(geometry), std::move(state), std::move(wet)};
}

}  // namespace

StateOwner structure_owner(const Case& run_case) {
  return {"structure", "Fissura " FISSURA_VERSION, format, case_hash(run_case)};
}

std::vector<std::byte> save_snapshot(const StateOwner& owner, const StructureHistory& history,
                                     const Geometry& geometry, const StructureState& state,
                                     const std::vector<ElementIndex>& wet) {
  ByteWriter bytes;
  begin_state(owner, bytes);
  save_history(history, bytes);
  save_geometry(geometry, bytes);
  bytes.put(wet);
  bytes.put(state.body.displacement);
  bytes.put(state.body.velocity);
  save_damage(geometry.tiles, state.body.damage, bytes);
  save_joints(state.joints, bytes);
  state.mass_scaling.save(bytes);
  bytes.put(state.failure_work_gone);
  bytes.put(state.crossing_seeds);
  state.sources.save(bytes);
  return end_state(bytes);
}

Snapshot restore_snapshot(const std::vector<std::byte>& bytes, const StateOwner& owner,
                          const StructureModel& model) {
  ByteReader reader(state_inside(bytes, owner));
  return read_snapshot(reader, model);
}

}  // namespace fissura::structure
