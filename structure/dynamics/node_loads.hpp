// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "structure/dynamics/body.hpp"
#include "structure/mesh/node_elements.hpp"

/// What the elements and sides around one node give it: the same terms in the same order whether the whole
/// body is built or follows a change of the mesh.
namespace fissura::structure {

/// How a node may move.
struct NodeConstraint {
  std::array<bool, 2> held{false, false};    ///< not moved by forces in x, y
  std::optional<PrescribedNode> prescribed;  ///< then both are held
};

class NodeLoads {
 public:
  /// All must outlive this; `elements` those around each node of `mesh`.
  NodeLoads(const Mesh& mesh, const NodeElements& elements, const Case& settings);

  /// Sum of density times a third of each element's area [kg/m].
  [[nodiscard]] double mass(NodeIndex node) const;

  [[nodiscard]] NodeConstraint constraint(NodeIndex node) const;

  /// External force in x, y [N/m] (see build_body), `held` as in the node's constraint and `in_situ` of the
  /// elements around set before. Throws SolverError if the in-situ state is out of equilibrium at the node.
  [[nodiscard]] std::array<double, 2> external_force(NodeIndex node, const std::array<bool, 2>& held,
                                                     const std::vector<InSituElement>& in_situ) const;

 private:
  struct InSituForce {
    std::array<double, 2> exact{}, stored{};  // internal, of the stress in double and in stored precision
    double scale = 0;                         // sum of the magnitudes in them
  };
  struct SideEdge {
    NodeIndex here = 0, there = 0;
    int side = 0;
    double length = 0;
  };

  [[nodiscard]] std::vector<SideEdge> side_edges(NodeIndex node) const;
  void add_in_situ_tractions(NodeIndex node, std::array<double, 2>& force) const;
  void add_case_tractions(NodeIndex node, std::array<double, 2>& force) const;
  [[nodiscard]] InSituForce in_situ_force(NodeIndex node, const std::vector<InSituElement>& in_situ) const;
  [[nodiscard]] bool on_side(NodeIndex node, int side) const { return (sides_[node] >> side & 1) != 0; }

  const Mesh& mesh_;
  const NodeElements& elements_;
  const Case& settings_;
  std::array<const Boundary*, 4> boundary_;
  std::vector<std::uint8_t> sides_;        // of each node: bit `side` set if it lies there
  std::vector<std::uint8_t> on_fracture_;  // of each node: 1 if it belongs to a contact unit
};

}  // namespace fissura::structure
