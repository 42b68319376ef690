// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/case/case.hpp"

/// The triangulation and the fracture geometry in it. Changes at coupling times only.
namespace fissura::structure {

using NodeIndex = std::uint32_t;
using ElementIndex = std::uint32_t;
using VertexIndex = std::uint32_t;
using UnitIndex = std::uint32_t;
using EdgeIndex = std::uint32_t;

inline constexpr UnitIndex no_unit = 0xffffffffu;

enum class Side : std::uint8_t { west = 0, east = 1, south = 2, north = 3 };

/// A pair of coincident nodes on the two sides of a fracture (a "contact unit"). Edges of several lines that
/// meet with the same pair are merged. The face vector points from `minus` to `plus`; opening is
///   e = (u_plus - u_minus) . face / length   (positive when the faces are apart, [m])
/// and a pressure p loads `plus` with +p face and `minus` with -p face (per unit thickness), so that the
/// volume per unit thickness is e * length with the same vector.
struct ContactUnit {
  NodeIndex minus = 0, plus = 0;  ///< right-hand and left-hand side of the line's direction
  std::array<double, 2> face{};   ///< sum of half of each adjoining edge's length times its normal [m]
  double length = 0;              ///< sum of half of each adjoining edge's length [m]
  VertexIndex vertex = 0;
  std::uint32_t line = 0;  ///< adjoining line with the greatest tensile strength, index into `Mesh::lines`
};

/// A mesh vertex on the fracture lines.
struct FractureVertex {
  Point position{};
  std::vector<UnitIndex> units;  ///< empty at an unsplit end of a line (a tip)
  NodeIndex node = 0;            ///< one of the nodes here; the only one at an unsplit end
  std::vector<EdgeIndex> edges;  ///< that begin or end here, ascending
};

/// One mesh edge on a fracture line, in the direction of the line.
struct FractureEdge {
  VertexIndex begin = 0, end = 0;
  std::uint32_t line = 0;  ///< index into `Mesh::lines`
  double length = 0;       ///< [m]
  std::array<UnitIndex, 2> unit{no_unit, no_unit};  ///< of which half of this edge is a part, at begin and end; no_unit where unsplit

  /// The other end. @pre `vertex` is one of the two
  [[nodiscard]] VertexIndex across(VertexIndex vertex) const { return vertex == begin ? end : begin; }
  /// Unit at the end `vertex`.
  [[nodiscard]] UnitIndex unit_at(VertexIndex vertex) const { return unit[vertex == begin ? 0 : 1]; }
};

struct Mesh {
  std::vector<FractureLine>
      lines;  ///< those of the case that are meshed, then one for every fracture that grew or nucleated
  std::vector<Point> position;                       ///< of each node, undeformed [m]
  std::vector<std::array<NodeIndex, 3>> elements;    ///< counter-clockwise, in Hilbert order
  std::array<std::vector<NodeIndex>, 4> side_nodes;  ///< nodes on each Side, corners on two
  std::vector<FractureVertex> vertices;              ///< line by line, along each line; shared ones once
  std::vector<FractureEdge> edges;                   ///< line by line, along each line
  std::vector<ContactUnit> units;
  std::vector<NodeIndex> unused_nodes;  ///< places in `position` that no element uses, ascending
};

/// Appends an edge and lists it at its ends; its units are left to the caller. @returns its index
EdgeIndex add_edge(Mesh& mesh, FractureEdge edge);

/// Area of element `element`, > 0 [m2].
double element_area(const Mesh& mesh, ElementIndex element);

}  // namespace fissura::structure
