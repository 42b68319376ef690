// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "common/flow_solver/flow_solver.hpp"

/// A flow solver behind its interface, in fractures made by hand.
namespace fissura::network::test {

/// Water in fractures 10 m high, a well that is shut in, no leak-off.
FlowCase water();

/// From 0 s on. @param target  per unit thickness [m2/s], or [Pa]
PumpingStage from_the_start(WellControl control, double target);

/// Nodes 1, 2, ... at x = 0, h, 2h, ... joined by segments of the same numbers; end nodes stand for half a
/// segment. @param perforations  positions in the chain
Insertion chain(std::size_t nodes, double h, const std::vector<std::size_t>& perforations);

class CellSetup {
 public:
  CellSetup(FlowSolver& solver, const FlowCase& flow_case, const Insertion& first);

  void insert(const Insertion& insertion);
  /// The next interval, with what `interval` says of apertures and rock.
  FlowAnswer advance(double duration);
  /// Content of each node [m].
  [[nodiscard]] std::vector<double> content() const;

  CouplingInterval interval;
  FractureNetwork network;

 private:
  FlowSolver& solver_;
};

}  // namespace fissura::network::test
