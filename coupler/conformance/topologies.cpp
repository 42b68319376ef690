// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/topologies.hpp"

#include <algorithm>

namespace fissura::coupler::conformance {

namespace {

constexpr FractureId first_fracture = 4;

/// Ids that no solver can mistake for indices: large, and falling where the index rises.
NodeId node_id(std::size_t count) {
  return 1000 - static_cast<NodeId>(count) + (count >= 900 ? 1000000 : 0);
}
SegmentId segment_id(std::size_t count) {
  return 5000 + 7 * static_cast<SegmentId>(count);
}

/// Takes what one insertion adds to a network.
class Builder {
 public:
  explicit Builder(const FractureNetwork& network) : network_(network), node_count_(network.nodes().size()) {
    for (SegmentId count = 0; network.knows_segment(segment_id(count)); ++count) segment_count_ = count + 1;
    if (!network.empty()) insertion_.revision = network.revision() + 1;
  }

  /// @returns its id
  NodeId add_node(NetworkNode node) {
    node.id = node_id(node_count_++);
    insertion_.new_nodes.push_back(node);
    return node.id;
  }
  void add_segment(NodeId a, NodeId b, double length, SegmentKind kind, FractureId fracture) {
    insertion_.new_segments.push_back({.id = segment_id(segment_count_++),
                                       .node_a = a,
                                       .node_b = b,
                                       .fracture = fracture,
                                       .kind = kind,
                                       .length = length});
  }
  void add_parent(NodeId node, NodeId parent) { insertion_.parents.push_back({node, parent}); }
  void perforate(NodeId node) { insertion_.new_perforations.push_back({"well", node}); }
  void remove(SegmentId id) { insertion_.removed_segments.push_back(id); }

  /// An old node with another role and length.
  void update(std::size_t index, NodeRole role, double lengthening) {
    const NodeId id = network_.nodes()[index].id;
    auto found = std::find_if(insertion_.updated_nodes.begin(), insertion_.updated_nodes.end(),
                              [id](const NetworkNode& node) { return node.id == id; });
    if (found == insertion_.updated_nodes.end())
      found = insertion_.updated_nodes.insert(found, network_.nodes()[index]);
    if (found->role != NodeRole::perforation) found->role = role;
    found->lumped_length += lengthening;
  }

  /// A row of nodes from an old one; the last is a tip.
  void grow(std::size_t from, std::size_t length, double step_x, double step_y, double spacing,
            SegmentKind kind, NetworkNode like) {
    NodeId before = network_.nodes()[from].id;
    for (std::size_t k = 1; k <= length; ++k) {
      like.x = network_.nodes()[from].x + static_cast<double>(k) * step_x;
      like.y = network_.nodes()[from].y + static_cast<double>(k) * step_y;
      like.lumped_length = k == length ? spacing / 2 : spacing;
      like.role = k == length ? NodeRole::tip : NodeRole::interior;
      const NodeId node = add_node(like);
      add_segment(before, node, spacing, kind, like.fracture);
      add_parent(node, before);
      before = node;
    }
  }

  Insertion take() { return std::move(insertion_); }

 private:
  const FractureNetwork& network_;
  Insertion insertion_;
  std::size_t node_count_, segment_count_ = 0;
};

std::size_t end_of(const FractureNetwork& network, double direction) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < network.nodes().size(); ++i)
    if (network.nodes()[i].y == 0 && direction * network.nodes()[i].x > direction * network.nodes()[found].x)
      found = i;
  return found;
}

NetworkNode like(FractureId fracture, double time) {
  return {.fracture = fracture, .exposure_time = time};
}

Insertion slit(std::size_t nodes, double spacing, std::size_t perforated, SegmentKind kind,
               NetworkNode like_this) {
  const FractureNetwork none;
  Builder builder(none);
  std::vector<NodeId> ids;
  for (std::size_t i = 0; i < nodes; ++i) {
    const bool at_end = i == 0 || i + 1 == nodes;
    like_this.x = (static_cast<double>(i) - static_cast<double>(nodes - 1) / 2) * spacing;
    like_this.lumped_length = at_end ? spacing / 2 : spacing;
    like_this.role = i == perforated ? NodeRole::perforation : at_end ? NodeRole::tip : NodeRole::interior;
    ids.push_back(builder.add_node(like_this));
  }
  // Every other segment points west.
  for (std::size_t i = 0; i + 1 < nodes; ++i) {
    const std::size_t a = i % 2 == 0 ? i : i + 1, b = i % 2 == 0 ? i + 1 : i;
    builder.add_segment(ids[a], ids[b], spacing, kind, like_this.fracture);
  }
  builder.perforate(ids[perforated]);
  return builder.take();
}

void grow_tip(Builder& builder, const FractureNetwork& network, double direction, double spacing,
              double time) {
  const std::size_t tip = end_of(network, direction);
  builder.update(tip, NodeRole::interior, spacing / 2);
  builder.grow(tip, 1, direction * spacing, 0, spacing, SegmentKind::hydraulic,
               like(network.nodes()[tip].fracture, time));
}

void grow_arm(Builder& builder, std::size_t node, std::size_t length, double spacing, double time) {
  builder.update(node, NodeRole::junction, spacing / 2);
  builder.grow(node, length, 0, spacing, spacing, SegmentKind::hydraulic, like(first_fracture + 1, time));
}

}  // namespace

Insertion straight_slit(std::size_t nodes, double spacing, std::size_t perforated) {
  return slit(nodes, spacing, perforated, SegmentKind::hydraulic, like(first_fracture, 0));
}

Insertion natural_slit(std::size_t nodes, double spacing, std::size_t perforated, double formation_pressure,
                       double compliance) {
  return slit(nodes, spacing, perforated, SegmentKind::natural,
              {.fracture = first_fracture,
               .saturated = true,
               .formation_pressure = formation_pressure,
               .joint_compliance = compliance});
}

Insertion tip_growth(const FractureNetwork& network, double spacing, double time) {
  Builder builder(network);
  grow_tip(builder, network, 1, spacing, time);
  return builder.take();
}

Insertion junction(const FractureNetwork& network, std::size_t node, std::size_t length, double spacing,
                   double time) {
  Builder builder(network);
  grow_arm(builder, node, length, spacing, time);
  return builder.take();
}

Insertion several_at_once(const FractureNetwork& network, std::size_t node, double spacing, double time) {
  Builder builder(network);
  grow_tip(builder, network, 1, spacing, time);
  grow_tip(builder, network, -1, spacing, time);
  grow_arm(builder, node, 2, spacing, time);
  return builder.take();
}

Insertion split_segment(const FractureNetwork& network, std::size_t segment, double time) {
  Builder builder(network);
  const NetworkSegment old = network.segments()[segment];
  const std::size_t a = network.index_of(old.node_a), b = network.index_of(old.node_b);
  const double half = old.length / 2;
  for (const std::size_t end : {a, b}) builder.update(end, network.nodes()[end].role, -half / 2);
  NetworkNode middle = like(old.fracture, time);
  middle.x = (network.nodes()[a].x + network.nodes()[b].x) / 2;
  middle.y = (network.nodes()[a].y + network.nodes()[b].y) / 2;
  middle.lumped_length = half;
  const NodeId id = builder.add_node(middle);
  builder.add_parent(id, old.node_a);
  builder.remove(old.id);
  builder.add_segment(old.node_a, id, half, old.kind, old.fracture);
  builder.add_segment(id, old.node_b, half, old.kind, old.fracture);
  return builder.take();
}

Insertion natural_branch(const FractureNetwork& network, std::size_t node, std::size_t length, double spacing,
                         double formation_pressure, double compliance, double time) {
  Builder builder(network);
  builder.update(node, NodeRole::junction, spacing / 2);
  builder.grow(node, length, 0, -spacing, spacing, SegmentKind::natural,
               {.fracture = first_fracture + 2,
                .exposure_time = time,
                .saturated = true,
                .formation_pressure = formation_pressure,
                .joint_compliance = compliance});
  return builder.take();
}

CouplingInterval rigid_interval(const FractureNetwork& network, double begin, double end, double aperture) {
  const std::size_t count = network.nodes().size();
  CouplingInterval interval;
  interval.begin = begin;
  interval.end = end;
  interval.aperture.assign(count, aperture);
  interval.aperture_rate.assign(count, 0.0);
  interval.reference_pressure.assign(count, 0.0);
  interval.compliance.assign(count, 0.0);
  interval.closed.assign(count, 0);
  return interval;
}

double integral(const FractureNetwork& network, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += network.nodes()[i].lumped_length * values[i];
  return sum;
}

}  // namespace fissura::coupler::conformance
