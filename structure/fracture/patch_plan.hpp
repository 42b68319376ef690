// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "structure/fracture/patch_mesh.hpp"
#include "structure/mesh/node_elements.hpp"

namespace fissura::structure {

/// A node of the mesh as it will be: the index of an existing one, or number_of_nodes + k for the k-th of PatchPlan::nodes.
using PlannedNodeIndex = std::uint32_t;

/// A node that an insertion makes.
struct PlannedNode {
  enum class Origin {
    copy,         ///< the second side of `source`, which a fracture splits
    interpolated  ///< inside an element that goes
  };
  Origin origin = Origin::interpolated;
  Point position{};
  NodeIndex source = 0;                   ///< of a copy
  std::array<NodeIndex, 3> corner{};      ///< of the element it lies in
  std::array<double, 3> weight{};         ///< of those corners
};

/// An element outside the patch whose corner gets another node.
struct Rewiring {
  ElementIndex element = 0;
  int corner = 0;
  PlannedNodeIndex node = 0;
};

/// One end of a fracture edge: an existing one, or number_of_edges + k for the k-th of PatchPlan::new_edges.
struct PlannedEdgeEnd {
  EdgeIndex edge = 0;
  int end = 0;  ///< 0 its begin, 1 its end
};

/// A contact unit as it will be at a vertex the insertion touches.
struct PlannedUnit {
  PlannedNodeIndex minus = 0, plus = 0;
  std::array<double, 2> face{};
  double length = 0;
  VertexIndex vertex = 0;
  std::uint32_t line = 0;
  std::optional<UnitIndex> same;    ///< the existing unit it is
  std::optional<UnitIndex> source;  ///< the existing unit it was a part of
  std::vector<PlannedEdgeEnd> edge_ends;  ///< whose halves it is made of
};

/// A point of the line that is inserted.
struct LineVertex {
  Point position{};                    ///< [m]
  std::optional<VertexIndex> vertex;   ///< the fracture vertex there; a new one otherwise
};

/// A line to be inserted, at a tip or anywhere in the rock: what replaces a patch of the mesh.
struct PatchPlan {
  std::vector<ElementIndex> removed;                       ///< ascending
  std::vector<std::array<PlannedNodeIndex, 3>> made;
  std::vector<PlannedNode> nodes;
  std::vector<Rewiring> rewired;
  std::vector<NodeIndex> unused;                           ///< ascending
  std::vector<FractureVertex> new_vertices;                ///< `node` is a PlannedNodeIndex, `units` empty
  std::vector<FractureEdge> new_edges;
  std::vector<PlannedUnit> units;                          ///< all of the vertices below
  std::vector<VertexIndex> split;                          ///< vertices with units now, in order of first touch
  Point tip{};                                             ///< end of the line [m]
  double smallest_angle = 0;                               ///< of the elements made [rad]
  double smallest_altitude = 0;                            ///< [m]
};

/// Everything a plan is made from.
struct PlanInput {
  const Mesh& mesh;
  const NodeElements& node_elements;
  std::size_t vertices = 0;  ///< fracture vertices, those planned for other tips included: the first new one has this index
  std::uint32_t line = 0;    ///< of the new edges, index into Mesh::lines
};

/// Plans the edges along `line` (at least two points, in order) in the patch `elements` with `patch` as its mesh: gives every corner of the
/// new triangles and of the elements around them a node. The corners around a vertex fall into wedges between the fracture edges there;
/// each wedge has a node of its own, an existing one where it can.
PatchPlan plan_patch(const PlanInput& input, const std::vector<LineVertex>& line, const std::vector<ElementIndex>& elements,
                     const PatchOutline& outline, const PatchMesh& patch);

}  // namespace fissura::structure
