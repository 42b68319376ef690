// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/state_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>


namespace fissura::structure {

namespace {

struct Motion {
  std::array<double, 2> momentum{};
  double scale = 0, kinetic_energy = 0;

  void add(double mass, const double* velocity) {
    const double squared = velocity[0] * velocity[0] + velocity[1] * velocity[1];
    momentum[0] += mass * velocity[0];
    momentum[1] += mass * velocity[1];
    scale += mass * std::sqrt(squared);
    kinetic_energy += mass * squared / 2;
  }
};

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

StateTransfer::StateTransfer(const GrowthPlan& plan, const Geometry& geometry, const StructureState& state)
    : plan_(plan) {
  const Mesh& mesh = geometry.mesh;
  const State& body = state.body;
  std::set<NodeIndex> all_nodes;
  for (const PatchPlan& patch : plan.patches) {
    std::set<NodeIndex> nodes;
    for (const ElementIndex element : patch.removed)
      nodes.insert(mesh.elements[element].begin(), mesh.elements[element].end());
    for (const Rewiring& rewiring : patch.rewired)
      nodes.insert(mesh.elements[rewiring.element].begin(), mesh.elements[rewiring.element].end());
    auto& values = value_.emplace_back();
    for (const PlannedNode& node : patch.nodes) {
      std::array<double, 4> value{};
      const auto add = [&](NodeIndex from, double weight) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
          value[axis] += weight * body.displacement[2 * from + axis];
          value[2 + axis] += weight * body.velocity[2 * from + axis];
        }
      };
      if (node.origin == PlannedNode::Origin::copy)
        add(node.source, 1);
      else
        for (std::size_t k = 0; k < 3; ++k) add(node.corner[k], node.weight[k]);
      values.push_back(value);
    }
    Motion of_patch;
    for (const NodeIndex node : nodes) of_patch.add(geometry.body.mass[node], &body.velocity[2 * node]);
    momentum_.push_back(of_patch.momentum);
    std::set_difference(nodes.begin(), nodes.end(), patch.unused.begin(), patch.unused.end(),
                        std::back_inserter(staying_.emplace_back()));
    all_nodes.merge(nodes);
  }
  Motion motion;
  for (const NodeIndex node : all_nodes) motion.add(geometry.body.mass[node], &body.velocity[2 * node]);
  before_.mass = total(geometry.body.mass);
  before_.momentum = motion.momentum;
  before_.momentum_scale = motion.scale;
  before_.kinetic_energy = state.mass_scaling.scale() * motion.kinetic_energy;
}

TransferBalance StateTransfer::carry_over(const MeshInsertion& insertion, const Geometry& geometry,
                                          StructureState& state) const {
  State& body = state.body;
  const std::vector<double>& mass = geometry.body.mass;
  body.displacement.resize(2 * geometry.mesh.position.size());
  body.velocity.resize(2 * geometry.mesh.position.size());
  for (const NodeIndex node : insertion.change.unused_nodes)
    for (std::size_t axis = 0; axis < 2; ++axis) body.displacement[2 * node + axis] = body.velocity[2 * node + axis] = 0;
  const auto add = [&](NodeIndex node, Motion& sum) { sum.add(mass[node], &body.velocity[2 * node]); };
  for (std::size_t k = 0; k < plan_.patches.size(); ++k) {
    double free_mass = 0;
    Motion motion;
    for (const NodeIndex node : staying_[k]) add(node, motion);
    for (std::size_t i = 0; i < value_[k].size(); ++i) {
      const NodeIndex node = insertion.node[k][i];
      for (std::size_t axis = 0; axis < 2; ++axis) {
        body.displacement[2 * node + axis] = value_[k][i][axis];
        body.velocity[2 * node + axis] = value_[k][i][2 + axis];
      }
      add(node, motion);
      if (plan_.patches[k].nodes[i].origin == PlannedNode::Origin::interpolated) free_mass += mass[node];
    }
    for (std::size_t i = 0; i < value_[k].size(); ++i)
      if (plan_.patches[k].nodes[i].origin == PlannedNode::Origin::interpolated)
        for (std::size_t axis = 0; axis < 2; ++axis)
          body.velocity[2 * insertion.node[k][i] + axis] += (momentum_[k][axis] - motion.momentum[axis]) / free_mass;
  }

  Motion after;
  for (const NodeIndex node : insertion.change.touched_nodes) add(node, after);
  TransferBalance balance;
  balance.mass_error = std::abs(total(mass) - before_.mass) / before_.mass;
  if (before_.momentum_scale > 0)
    balance.momentum_error = std::hypot(after.momentum[0] - before_.momentum[0], after.momentum[1] - before_.momentum[1]) /
                             before_.momentum_scale;
  balance.kinetic_energy = state.mass_scaling.scale() * after.kinetic_energy;
  return balance;
}

}  // namespace fissura::structure
