// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/central_difference.hpp"

#include <omp.h>

#include <algorithm>

#include "common/errors.hpp"

namespace fissura::structure {

namespace {

std::array<double, 2> sum_slots(const NodeSlots& nodes, std::size_t i,
                                const std::vector<std::array<double, 2>>& slot_force) {
  std::array<double, 2> sum{0, 0};
  for (std::size_t k = nodes.first[i]; k < nodes.first[i + 1]; ++k)
    for (int axis = 0; axis < 2; ++axis) sum[axis] += slot_force[nodes.slot[k]][axis];
  return sum;
}

double reached_fraction(const PrescribedNode& prescribed, double time) {
  if (time < 0) return 0;
  return time < prescribed.ramp ? time / prescribed.ramp : 1;
}

void prescribe(const PrescribedNode& prescribed, const Step& step, State& state) {
  const double now = reached_fraction(prescribed, step.end);
  const double before = reached_fraction(prescribed, step.end - step.size);
  for (int axis = 0; axis < 2; ++axis) {
    const std::size_t dof = 2 * std::size_t{prescribed.node} + axis;
    state.velocity[dof] = (now - before) * prescribed.displacement[axis] / step.size;
    state.displacement[dof] = now * prescribed.displacement[axis];
  }
}

}  // namespace

State state_at_rest(const Body& body) {
  return {std::vector<double>(2 * body.mass.size()), std::vector<double>(2 * body.mass.size()), {}};
}

State state_at_rest(const Body& body, const Tiles& tiles) {
  State state = state_at_rest(body);
  state.damage = intact_damage(tiles);
  return state;
}

CentralDifference::CentralDifference(const Body& body, const Tiles& tiles, const Elasticity& moduli,
                                     int threads)
    : body_(body),
      tiles_(tiles),
      moduli_(moduli),
      slot_force_(tiles.slots),
      joint_force_(2 * tiles.joint.node.size()),
      workspace_(static_cast<std::size_t>(threads)) {}

CentralDifference::CentralDifference(const Body& body, const Tiles& tiles, const Elasticity& moduli,
                                     const RockFailure& law, int threads)
    : CentralDifference(body, tiles, moduli, threads) {
  law_ = law;
  lowest_strength_ = lowest_strength(law.tension, longest_edge(tiles));
}

void CentralDifference::advance(State& state, const Step& step) {
  ENSURE(!law_ || state.damage.size() == tiles_.tile.size());
  const int threads =
      static_cast<int>(std::min(workspace_.size(), std::max<std::size_t>(tiles_.tile.size(), 1)));
  const StepFactors factors(step);
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    TileWorkspace& workspace = workspace_[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(dynamic)
    for (std::size_t t = 0; t < tiles_.tile.size(); ++t) advance_tile(t, state, factors, workspace);
#pragma omp for schedule(static) nowait
    for (std::size_t i = 0; i < tiles_.shared.node.size(); ++i) advance_shared_node(i, state, factors);
#pragma omp for schedule(static) nowait
    for (std::size_t i = 0; i < tiles_.joint.node.size(); ++i) gather_joint_force(i);
    if (!body_.prescribed.empty()) {
#pragma omp barrier
#pragma omp for schedule(static) nowait
      for (std::size_t i = 0; i < body_.prescribed.size(); ++i) prescribe(body_.prescribed[i], step, state);
    }
  }
}

void CentralDifference::advance_tile(std::size_t t, State& state, const StepFactors factors,
                                     TileWorkspace& workspace) {
  const Tile& tile = tiles_.tile[t];
  gather_nodes(tile, state.displacement, workspace);
  const std::size_t next = t + workspace_.size();
  const ReadAhead ahead(next < tiles_.tile.size() ? &tiles_.tile[next] : nullptr, state.displacement.data(),
                        state.velocity.data());
  if (law_)
    add_failing_forces(tile, moduli_, *law_, lowest_strength_, ahead, state.damage[t], workspace);
  else
    add_elastic_forces(tile, moduli_, ahead, workspace);

  for (std::size_t i = 0; i < tile.interior.size(); ++i) {
    const InteriorNode& node = tile.interior[i];
    const std::size_t dof = 2 * std::size_t{tile.nodes[i]};
    integrate(load_pair(workspace.force[i].data()) + load_pair(node.external_force.data()),
              Pair{node.inverse_mass, node.inverse_mass}, factors, &state.velocity[dof],
              &state.displacement[dof]);
  }
  std::copy_n(workspace.force.begin() + static_cast<std::ptrdiff_t>(tile.interior.size()),
              tile.shared_nodes(), slot_force_.begin() + static_cast<std::ptrdiff_t>(tile.first_slot));
}

void CentralDifference::advance_shared_node(std::size_t i, State& state, const StepFactors factors) const {
  const auto force = sum_slots(tiles_.shared, i, slot_force_);
  const NodeIndex node = tiles_.shared.node[i];
  const std::size_t dof = 2 * std::size_t{node};
  integrate(load_pair(force.data()) + load_pair(&body_.external_force[dof]),
            load_pair(body_.inverse_mass[node].data()), factors, &state.velocity[dof],
            &state.displacement[dof]);
}

void CentralDifference::gather_joint_force(std::size_t i) {
  const auto force = sum_slots(tiles_.joint, i, slot_force_);
  for (int axis = 0; axis < 2; ++axis)
    joint_force_[2 * i + axis] =
        force[axis] + body_.external_force[2 * std::size_t{tiles_.joint.node[i]} + axis];
}

}  // namespace fissura::structure
