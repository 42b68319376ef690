// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/fracture_network/insertion_json.hpp"

#include <fmt/format.h>

#include "common/errors.hpp"
#include "common/exact_json.hpp"

namespace fissura {

namespace {

using nlohmann::json;

json to_json(const NetworkNode& node) {
  return {{"id", node.id},
          {"x", node.x},
          {"y", node.y},
          {"lumped_length", node.lumped_length},
          {"fracture", node.fracture},
          {"role", static_cast<int>(node.role)},
          {"exposure_time", node.exposure_time},
          {"saturated", node.saturated},
          {"formation_pressure", node.formation_pressure},
          {"joint_compliance", node.joint_compliance}};
}

json to_json(const NetworkSegment& segment) {
  return {{"id", segment.id},
          {"node_a", segment.node_a},
          {"node_b", segment.node_b},
          {"fracture", segment.fracture},
          {"kind", static_cast<int>(segment.kind)},
          {"length", segment.length}};
}

json to_json(const NodeParent& pair) { return {{"node", pair.node}, {"parent", pair.parent}}; }

json to_json(const PerforationNode& perforation) {
  return {{"name", perforation.name}, {"node", perforation.node}};
}

template <typename Enumeration>
Enumeration enumerator(const json& entry, const char* key, int last) {
  const int number = exactly<int>(entry.at(key));
  if (number < 0 || number > last)
    throw ProtocolError(fmt::format("insertion: {} must lie in [0, {}], found {}", key, last, number));
  return static_cast<Enumeration>(number);
}

void from_json(const json& entry, NetworkNode& node) {
  node.id = exactly<NodeId>(entry.at("id"));
  node.x = entry.at("x").get<double>();
  node.y = entry.at("y").get<double>();
  node.lumped_length = entry.at("lumped_length").get<double>();
  node.fracture = exactly<FractureId>(entry.at("fracture"));
  node.role = enumerator<NodeRole>(entry, "role", static_cast<int>(NodeRole::perforation));
  node.exposure_time = entry.at("exposure_time").get<double>();
  node.saturated = entry.value("saturated", false);
  node.formation_pressure = entry.value("formation_pressure", 0.0);
  node.joint_compliance = entry.value("joint_compliance", 0.0);
}

void from_json(const json& entry, NetworkSegment& segment) {
  segment.id = exactly<SegmentId>(entry.at("id"));
  segment.node_a = exactly<NodeId>(entry.at("node_a"));
  segment.node_b = exactly<NodeId>(entry.at("node_b"));
  segment.fracture = exactly<FractureId>(entry.at("fracture"));
  segment.kind = enumerator<SegmentKind>(entry, "kind", static_cast<int>(SegmentKind::natural));
  segment.length = entry.at("length").get<double>();
}

void from_json(const json& entry, NodeParent& pair) {
  pair.node = exactly<NodeId>(entry.at("node"));
  pair.parent = exactly<NodeId>(entry.at("parent"));
}

void from_json(const json& entry, PerforationNode& perforation) {
  perforation.name = entry.at("name").get<std::string>();
  perforation.node = exactly<NodeId>(entry.at("node"));
}

template <typename T>
json list_to_json(const std::vector<T>& list) {
  json array = json::array();
  for (const T& entry : list) array.push_back(to_json(entry));
  return array;
}

template <typename T>
std::vector<T> list_from_json(const json& array) {
  std::vector<T> list;
  for (const json& entry : array) from_json(entry, list.emplace_back());
  return list;
}

}  // namespace

json insertion_to_json(const Insertion& insertion) {
  return {{"revision", insertion.revision},
          {"updated_nodes", list_to_json(insertion.updated_nodes)},
          {"new_nodes", list_to_json(insertion.new_nodes)},
          {"parents", list_to_json(insertion.parents)},
          {"new_segments", list_to_json(insertion.new_segments)},
          {"removed_segments", insertion.removed_segments},
          {"new_perforations", list_to_json(insertion.new_perforations)}};
}

Insertion insertion_from_json(const json& object) {
  try {
    Insertion insertion;
    insertion.revision = exactly<std::uint64_t>(object.at("revision"));
    insertion.updated_nodes = list_from_json<NetworkNode>(object.at("updated_nodes"));
    insertion.new_nodes = list_from_json<NetworkNode>(object.at("new_nodes"));
    insertion.parents = list_from_json<NodeParent>(object.at("parents"));
    insertion.new_segments = list_from_json<NetworkSegment>(object.at("new_segments"));
    insertion.removed_segments = exactly<std::vector<SegmentId>>(object.at("removed_segments"));
    insertion.new_perforations = list_from_json<PerforationNode>(object.at("new_perforations"));
    return insertion;
  } catch (const json::exception& fault) {
    throw ProtocolError(fmt::format("insertion: {}", fault.what()));
  }
}

}  // namespace fissura
