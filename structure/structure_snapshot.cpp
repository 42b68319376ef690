// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_snapshot.hpp"

#include "common/byte_archive.hpp"
#include "common/fracture_network/insertion_json.hpp"

namespace fissura::structure {

namespace {

constexpr std::uint64_t format = 1;

std::string text_of(const std::vector<Insertion>& insertions) {
  nlohmann::json list = nlohmann::json::array();
  for (const Insertion& insertion : insertions) list.push_back(insertion_to_json(insertion));
  return list.dump();
}

std::vector<Insertion> insertions_of(const std::string& text) {
  std::vector<Insertion> insertions;
  for (const nlohmann::json& entry : nlohmann::json::parse(text)) insertions.push_back(insertion_from_json(entry));
  return insertions;
}

}  // namespace

std::vector<std::byte> save_snapshot(const Snapshot& snapshot, const Geometry& geometry) {
  ByteWriter bytes;
  bytes.put(format);
  bytes.put(snapshot.time);
  bytes.put(snapshot.steps);
  bytes.put(text_of(snapshot.insertions));
  bytes.put(snapshot.state.body.displacement);
  bytes.put(snapshot.state.body.velocity);
  bytes.put(damage_records(geometry.tiles, snapshot.state.body.damage));
  bytes.put(snapshot.state.joints.state);
  bytes.put(snapshot.state.joints.released);
  bytes.put(snapshot.state.joints.ramp);
  bytes.put(snapshot.state.mass_scaling);
  return bytes.take();
}

Snapshot restore_snapshot(const std::vector<std::byte>& bytes, const Geometry& geometry,
                          const StructureState& pattern) {
  Snapshot snapshot{0, 0, {}, pattern};
  ByteReader reader(bytes);
  std::uint64_t found_format = 0;
  std::string insertions;
  std::vector<ElementDamage> damage;
  reader.get(found_format);
  if (found_format != format) throw Error(ExitCode::checkpoint_unusable, "the saved state has another format");
  reader.get(snapshot.time);
  reader.get(snapshot.steps);
  reader.get(insertions);
  reader.get(snapshot.state.body.displacement);
  reader.get(snapshot.state.body.velocity);
  reader.get(damage);
  reader.get(snapshot.state.joints.state);
  reader.get(snapshot.state.joints.released);
  reader.get(snapshot.state.joints.ramp);
  reader.get(snapshot.state.mass_scaling);
  reader.end();
  snapshot.insertions = insertions_of(insertions);
  if (!damage.empty()) snapshot.state.body.damage = damage_from_records(geometry.tiles, damage);
  const std::size_t units = geometry.mesh.units.size();
  if (snapshot.state.body.displacement.size() != 2 * geometry.mesh.position.size() ||
      snapshot.state.joints.state.size() != units || snapshot.state.joints.released.size() != units ||
      snapshot.state.joints.ramp.size() != units)
    throw Error(ExitCode::checkpoint_unusable, "the saved state belongs to another mesh");
  return snapshot;
}

}  // namespace fissura::structure
