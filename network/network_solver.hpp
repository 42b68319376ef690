// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "common/flow_solver/flow_solver.hpp"
#include "network/advance.hpp"
#include "network/checkpoint.hpp"
#include "network/graph.hpp"
#include "network/model.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// The implicit flow solver behind the interface that every flow solver has. Knows no message.
class NetworkSolver : public FlowSolver {
 public:
  /// @param each_iteration  called in every Newton iteration
  explicit NetworkSolver(std::function<void()> each_iteration = {});

  [[nodiscard]] std::set<std::string> physics() const override;
  [[nodiscard]] StateKept state_kept() const override { return StateKept::own_and_neutral; }
  void join(const FlowCase& flow_case) override;
  void insert(const Insertion& insertion, const FractureNetwork& network) override;
  /// Throws SolverError if the flow cannot be solved.
  FlowAnswer advance(const CouplingInterval& interval) override;
  /// Pressure, aperture, filled, content, leaked per node, flux per segment, fluid fractions.
  [[nodiscard]] std::vector<FlowField> report() const override;
  [[nodiscard]] std::vector<std::byte> save() const override;
  void restore(std::span<const std::byte> bytes, const FractureNetwork& network) override;
  [[nodiscard]] NeutralFlowState neutral_state() const override;
  void take_up(const NeutralFlowState& neutral, const FractureNetwork& network) override;
  /// Seconds at work, Newton iterations, factorisations, steps, halvings.
  [[nodiscard]] nlohmann::json finish() const override;

 private:
  /// A dry network only keeps the time.
  AdvanceReport pass_dry();
  [[nodiscard]] double predicted_aperture(std::size_t node) const;
  [[nodiscard]] FlowAnswer answer(const AdvanceReport& report) const;
  void stand_on(Graph graph);

  Model model_;
  Graph graph_;
  State state_;
  Interval interval_;
  Workspace workspace_;
  WorkFigures figures_;  ///< factorisations: those before the last restore
  double seconds_ = 0;   ///< of wall time at work
};

}  // namespace fissura::network
