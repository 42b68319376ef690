// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/byte_archive.hpp"
#include "common/fracture_network/fracture_network.hpp"

/// The history of a fracture network in a saved state.
namespace fissura {

constexpr NodeRole last_of(NodeRole) {
  return NodeRole::perforation;
}

constexpr SegmentKind last_of(SegmentKind) {
  return SegmentKind::natural;
}

auto parts(EitherOf<NetworkNode> auto& node) {
  return std::tie(node.id, node.x, node.y, node.lumped_length, node.fracture, node.role, node.exposure_time,
                  node.saturated, node.formation_pressure, node.joint_compliance);
}

auto parts(EitherOf<NetworkSegment> auto& segment) {
  return std::tie(segment.id, segment.node_a, segment.node_b, segment.fracture, segment.kind, segment.length);
}

auto parts(EitherOf<PerforationNode> auto& perforation) {
  return std::tie(perforation.name, perforation.node);
}

auto parts(EitherOf<Insertion> auto& insertion) {
  return std::tie(insertion.revision, insertion.updated_nodes, insertion.new_nodes, insertion.parents,
                  insertion.new_segments, insertion.removed_segments, insertion.new_perforations);
}

/// The network after these insertions. Throws Error(checkpoint_unusable) if there are none or one does not
/// follow the other.
FractureNetwork network_after(const std::vector<Insertion>& insertions);

}  // namespace fissura
