// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_snapshot.hpp"

#include <optional>

#include "common/byte_archive.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "structure/geometry_archive.hpp"

namespace fissura::structure {

namespace {

enum class SavedGeometry : std::uint8_t { of_the_case, included };

constexpr std::uint64_t format = 6;

std::string text_of(const std::vector<Insertion>& insertions) {
  nlohmann::json list = nlohmann::json::array();
  for (const Insertion& insertion : insertions) list.push_back(insertion_to_json(insertion));
  return list.dump();
}

std::vector<Insertion> insertions_of(const std::string& text) {
  std::vector<Insertion> insertions;
  for (const nlohmann::json& entry : nlohmann::json::parse(text))
    insertions.push_back(insertion_from_json(entry));
  return insertions;
}

void save_joints(const Joints& joints, ByteWriter& bytes) {
  bytes.put(joints.properties);
  bytes.put(joints.state);
  bytes.put(joints.released);
  bytes.put(joints.ramp);
}

void restore_joints(ByteReader& bytes, Joints& joints) {
  bytes.get(joints.properties);
  bytes.get(joints.state);
  bytes.get(joints.released);
  bytes.get(joints.ramp);
}

void require_same_mesh(const Mesh& mesh, const StructureState& state) {
  const Joints& joints = state.joints;
  const std::size_t nodes = mesh.position.size(), units = mesh.units.size();
  if (state.body.displacement.size() != 2 * nodes || state.body.velocity.size() != 2 * nodes ||
      joints.properties.size() != units || joints.state.size() != units || joints.released.size() != units ||
      joints.ramp.size() != units)
    throw Error(ExitCode::checkpoint_unusable, "the saved state belongs to another mesh");
}

}  // namespace

std::vector<std::byte> save_snapshot(const Snapshot& snapshot, const Geometry& geometry) {
  ByteWriter bytes;
  bytes.put(format);
  bytes.put(snapshot.time);
  bytes.put(snapshot.steps);
  bytes.put(text_of(snapshot.insertions));
  bytes.put(geometry.number == 0 ? SavedGeometry::of_the_case : SavedGeometry::included);
  if (geometry.number != 0) save_geometry(geometry, bytes);
  bytes.put(snapshot.state.body.displacement);
  bytes.put(snapshot.state.body.velocity);
  bytes.put(damage_records(geometry.tiles, snapshot.state.body.damage));
  save_joints(snapshot.state.joints, bytes);
  bytes.put(snapshot.state.mass_scaling);
  bytes.put(snapshot.state.failure_work_gone);
  bytes.put(snapshot.state.crossing_seeds);
  snapshot.state.sources.save(bytes);
  return bytes.take();
}

Snapshot restore_snapshot(const std::vector<std::byte>& bytes, const StructureModel& model,
                          Geometry& geometry) {
  ByteReader reader(bytes);
  std::uint64_t found_format = 0;
  reader.get(found_format);
  if (found_format != format)
    throw Error(ExitCode::checkpoint_unusable, "the saved state has another format");
  double time = 0;
  std::uint64_t steps = 0;
  std::string insertions;
  SavedGeometry saved{};
  reader.get(time);
  reader.get(steps);
  reader.get(insertions);
  reader.get(saved);
  std::optional<Geometry> other;
  if (saved == SavedGeometry::included)
    other = restore_geometry(reader);
  else if (geometry.number != 0)
    other = build_geometry(model);
  const Geometry& found = other ? *other : geometry;

  Snapshot snapshot{time, steps, insertions_of(insertions), initial_state(model, found)};
  std::vector<ElementDamage> damage;
  reader.get(snapshot.state.body.displacement);
  reader.get(snapshot.state.body.velocity);
  reader.get(damage);
  restore_joints(reader, snapshot.state.joints);
  reader.get(snapshot.state.mass_scaling);
  reader.get(snapshot.state.failure_work_gone);
  reader.get(snapshot.state.crossing_seeds);
  snapshot.state.sources.restore(reader);
  reader.end();
  require_same_mesh(found.mesh, snapshot.state);
  if (!damage.empty()) snapshot.state.body.damage = damage_from_records(found.tiles, damage);
  if (other) geometry = std::move(*other);
  return snapshot;
}

}  // namespace fissura::structure
