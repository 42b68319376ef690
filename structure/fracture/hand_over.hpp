// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/failure_map.hpp"
#include "structure/fracture/mesh_insertion.hpp"

namespace fissura::structure {

/// A failed band becomes a fracture: the faces take over the opening and what is left of the strength, the
/// rock beside them is whole again. The cohesion of a new pair of faces starts at
///   q_0 = omega w_c ,   T(q_0) = (1 - omega) f_t ,
/// omega the greatest share of strength lost within 0.75 tip_size, as a band that softens linearly has it.
/// The opening is the one in equilibrium with the rock around the patch, which is where the opening of the
/// band has gone: it is not interpolated, nor is it set. Healed are the elements made within 1.2 tip_size of
/// the line, but for the last 0.75 before an end that is a tip. Ahead of that the band goes on, through
/// triangles that have changed, with the opening it had: their damage grows to the strain it is spread over
/// now, and one without a record that lies in its way takes the most failed record around. The patch would
/// otherwise hold what the band has let go.
class HandOver {
 public:
  /// Before the mesh changes.
  HandOver(const GrowthPlan& plan, const StructureModel& model, const Geometry& geometry,
           const StructureState& state);

  /// Nodes there before whose displacement the hand-over will change, ascending.
  [[nodiscard]] const std::vector<NodeIndex>& moved_nodes() const { return moved_nodes_; }

  /// After mesh, joints, displacements and velocities have followed. `records` are those of the elements
  /// after the change, before healing; they become the damage of the state.
  void carry_out(const MeshInsertion& insertion, const StructureModel& model, const Geometry& geometry,
                 std::vector<ElementDamage> records, StructureState& state) const;

 private:
  struct Line {
    std::vector<Point> points;
    bool begins_at_tip = false, ends_at_tip = false;   ///< ends that stay unsplit
    std::vector<std::pair<VertexIndex, double>> lost;  ///< split vertices with omega
  };

  /// What an element had that goes.
  struct Removed {
    Point centroid{};  ///< [m]
    ElementDamage record;
  };

  [[nodiscard]] bool healed(const Point& at) const;
  bool follow_opening(const StructureModel& model, const Geometry& geometry,
                      const std::vector<ElementIndex>& elements, const std::vector<double>& displacement,
                      std::vector<ElementDamage>& records) const;

  const GrowthPlan& plan_;
  double h_;  ///< tip_size [m]
  std::vector<Line> lines_;
  std::vector<Removed> removed_;
  std::vector<NodeIndex> moved_nodes_;
};

}  // namespace fissura::structure
