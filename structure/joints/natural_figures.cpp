// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/joints/natural_figures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

namespace {

/// The fractures that are not natural ones, for distances from them.
class OtherFractures {
 public:
  OtherFractures(const Mesh& mesh, const FractureNetwork& network) : mesh_(mesh), network_(network) {}

  /// [m]; infinite if there are none.
  double distance(const Point& place) {
    if (!tree_) tree_.emplace(segments());
    return tree_->nearest(place).distance;
  }

 private:
  [[nodiscard]] std::vector<WeightedSegment> segments() const {
    std::vector<WeightedSegment> found;
    for (const FractureEdge& edge : mesh_.edges) {
      const FractureKind kind = mesh_.lines[edge.line].kind;
      const bool connected = network_.contains(edge.begin) || network_.contains(edge.end);
      if (kind == FractureKind::open || (kind == FractureKind::intact && connected))
        found.push_back({mesh_.vertices[edge.begin].position, mesh_.vertices[edge.end].position, 0});
    }
    return found;
  }

  const Mesh& mesh_;
  const FractureNetwork& network_;
  std::optional<SegmentTree> tree_;
};

}  // namespace

NaturalFigures natural_figures(const Mesh& mesh, const Joints& joints, const FractureNetwork& network,
                               double far) {
  NaturalFigures figures;
  OtherFractures others(mesh, network);
  for (UnitIndex index = 0; index < mesh.units.size(); ++index) {
    if (joints.properties[index].kind != FractureKind::natural) continue;
    const ContactUnit& unit = mesh.units[index];
    const JointState& state = joints.state[index];
    const double slip = std::abs(state.sliding);
    figures.greatest_slip = std::max(figures.greatest_slip, slip);
    if (!state.closed && state.opening - state.dilation > least_opening) figures.opened_length += unit.length;
    if (network.contains(unit.vertex)) figures.wetted_length += unit.length;
    const bool counts = slip > counted_slip;
    if (counts) figures.slipped_length += unit.length;
    if (!counts && slip <= figures.greatest_far_slip) continue;
    const double distance = others.distance(mesh.vertices[unit.vertex].position);
    if (counts && std::isfinite(distance)) figures.slip_distance = std::max(figures.slip_distance, distance);
    if (distance > far) figures.greatest_far_slip = std::max(figures.greatest_far_slip, slip);
  }
  return figures;
}

}  // namespace fissura::structure
