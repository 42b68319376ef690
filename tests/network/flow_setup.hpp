// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "network/advance.hpp"
#include "network/graph.hpp"
#include "network/model.hpp"
#include "network/state.hpp"
#include "network/transfer.hpp"

/// A flow problem made by hand: fractures without a rock around them.
namespace fissura::network::test {

/// Water of the paper in fractures of unit thickness: mu = 1.67 mPa s, K_f = 2 GPa, no leak-off, well shut
/// in.
Model water_model();

/// Injection of fluid 0 at `rate` [m2/s] from 0 s on.
Schedule constant_rate(double rate);

/// Well pressure [Pa] from 0 s on, fluid 0.
Schedule constant_pressure(double pressure);

/// Nodes 1, 2, ... at x = 0, h, 2h, ... joined by segments of the same numbers; end nodes stand for half a
/// segment. The perforations are positions in the chain.
Insertion straight_fracture(std::size_t nodes, double h, const std::vector<std::size_t>& perforations,
                            SegmentKind kind = SegmentKind::hydraulic);

struct FlowSetup {
  FlowSetup(Model the_model, const Insertion& first);

  void insert(const Insertion& insertion);

  /// One coupling interval of `duration` [s] with what `interval` says.
  AdvanceReport advance(double duration);

  /// Rigid, open fracture: aperture [m] everywhere, no compliance.
  void set_rigid(double aperture);

  /// Fluid in the fractures [m2].
  [[nodiscard]] double stored() const;

  Model model;
  Graph graph;
  State state;
  Interval interval;
  Workspace workspace;
};

}  // namespace fissura::network::test
