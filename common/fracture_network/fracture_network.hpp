// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

/// The fracture network: the language that structure, coupler and flow solver share (docs/protocol.md).
/// It holds what is connected to the fluid: vertices of the fractures whose faces may separate ("nodes") and the
/// pieces of fracture between them ("segments"). The closed vertex ahead of a tip is not part of it.
namespace fissura {

using NodeId = std::uint64_t;
using SegmentId = std::uint64_t;
using FractureId = std::uint64_t;

enum class NodeRole : std::uint8_t { interior = 0, tip = 1, junction = 2, perforation = 3 };
enum class SegmentKind : std::uint8_t { hydraulic = 0, natural = 1 };

struct NetworkNode {
  NodeId id = 0;
  double x = 0, y = 0;       ///< [m]
  double lumped_length = 0;  ///< trace length this node stands for: half of every adjoining edge [m]
  FractureId fracture = 0;
  NodeRole role = NodeRole::interior;
  double exposure_time = 0;  ///< when the faces were exposed to the fluid [s]
  bool saturated = false;    ///< new nodes: full of pore fluid when they join (natural fractures); dry otherwise
  double formation_pressure = 0;  ///< of that pore fluid [Pa]
  double joint_compliance = 0;    ///< hydraulic opening of touching faces per fluid pressure, mean over the arms [m/Pa]

  bool operator==(const NetworkNode&) const = default;
};

struct NetworkSegment {
  SegmentId id = 0;
  NodeId node_a = 0, node_b = 0;
  FractureId fracture = 0;
  SegmentKind kind = SegmentKind::hydraulic;
  double length = 0;  ///< [m]

  bool operator==(const NetworkSegment&) const = default;
};

/// A perforation of the case and the node it feeds.
struct PerforationNode {
  std::string name;
  NodeId node = 0;

  bool operator==(const PerforationNode&) const = default;
};

/// Which old node a new one grew from: a flow solver may take initial guesses (never content) from there.
struct NodeParent {
  NodeId node = 0, parent = 0;

  bool operator==(const NodeParent&) const = default;
};

/// One change of the network; applied whole or not at all. Revision 0 creates the network.
struct Insertion {
  std::uint64_t revision = 0;                  ///< the revision after this change
  std::vector<NetworkNode> updated_nodes;      ///< existing nodes whose role or lumped length changed
  std::vector<NetworkNode> new_nodes;
  std::vector<NodeParent> parents;             ///< of new nodes
  std::vector<NetworkSegment> new_segments;
  std::vector<SegmentId> removed_segments;
  std::vector<PerforationNode> new_perforations;

  bool operator==(const Insertion&) const = default;
};

/// The network at one topology revision. Ids are never reused; nodes are never removed, so that the order of
/// nodes() - the order of every array exchanged - only ever grows at its end.
class FractureNetwork {
 public:
  /// Applies one change. Throws ProtocolError, leaving the network as it was, if the revision is not the next
  /// one (0 for an empty network, then +1), an id exists already or is unknown, or a length is not positive.
  void apply(const Insertion& insertion);

  /// Revision of the last change applied. @pre !empty()
  [[nodiscard]] std::uint64_t revision() const;
  [[nodiscard]] bool empty() const { return !revision_.has_value(); }

  [[nodiscard]] const std::vector<NetworkNode>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<NetworkSegment>& segments() const { return segments_; }
  [[nodiscard]] const std::vector<PerforationNode>& perforations() const { return perforations_; }

  /// Position of a node in nodes(). Throws ProtocolError if the id is unknown.
  [[nodiscard]] std::size_t index_of(NodeId id) const;

  [[nodiscard]] bool contains(NodeId id) const { return node_index_.contains(id); }

  /// Whether a segment of this id is or was part of the network.
  [[nodiscard]] bool knows_segment(SegmentId id) const { return known_segments_.contains(id); }

  /// Indices into segments() of the segments at node `index`, in the order of segments().
  [[nodiscard]] std::vector<std::size_t> segments_at(std::size_t index) const;

  /// SHA-256 over revision, nodes (id, x, y, lumped length, fracture, role) and segments (id, a, b, length) in order,
  /// each number as 8 little-endian bytes; what an ACKNOWLEDGE carries. Layout in docs/protocol.md.
  [[nodiscard]] std::string topology_hash() const;

 private:
  std::optional<std::uint64_t> revision_;
  std::vector<NetworkNode> nodes_;
  std::vector<NetworkSegment> segments_;
  std::vector<PerforationNode> perforations_;
  std::unordered_map<NodeId, std::size_t> node_index_;
  std::unordered_map<SegmentId, bool> known_segments_;  ///< every id ever used
};

}  // namespace fissura
