// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "tests/network/flow_setup.hpp"

/// Natural fractures that join a flow problem, and a rock that follows the fluid without inertia.
namespace fissura::network::test {

struct NaturalFracture {
  double residual_aperture = 5e-5;  ///< [m]
  double joint_compliance = 1e-11;  ///< [m/Pa]
  double formation_pressure = 5e6;  ///< [Pa]
  double opening_pressure = 12e6;   ///< [Pa]
  double spacing = 0.5;             ///< [m]
};

/// A network in which every node knows what would part its faces.
struct NaturalSetup {
  NaturalSetup(Model model, const Insertion& first);

  /// Joins at once, for every one of `from` (positions of nodes), a natural fracture of 2 `half` + 1 nodes; a
  /// dry hydraulic segment leads from there to its middle.
  void join(const std::vector<std::size_t>& from, std::size_t half, const NaturalFracture& natural);

  /// A new dry hydraulic tip grows from node `from` [position].
  void grow(std::size_t from);

  /// The rock has opened as the network predicted; nodes above their opening pressure have parted.
  void follow();

  /// One interval of `duration` [s], after which the rock follows. Returns the report.
  AdvanceReport advance(double duration);

  [[nodiscard]] double relative_residual() const;
  [[nodiscard]] std::size_t count() const { return flow.graph.node_count(); }

  FlowSetup flow;
  std::vector<double> opening_pressure;  ///< [Pa]

 private:
  void insert(Insertion& insertion);
  NodeId next_id_;
  SegmentId next_segment_;
};

/// A hydraulic fracture of five nodes, perforated at the first, with apertures of `aperture` [m].
NaturalSetup pumped_fracture(Model model, double aperture);

}  // namespace fissura::network::test
