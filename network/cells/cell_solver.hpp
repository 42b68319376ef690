// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/flow_solver/flow_solver.hpp"
#include "common/flow_solver/pumping_schedule.hpp"
#include "network/cells/cell_law.hpp"
#include "network/cells/cell_state.hpp"

namespace fissura::cells {

/// What the well does during a piece of an interval, per unit thickness.
struct WellDemand {
  WellControl control = WellControl::rate;
  double target = 0;  ///< mean over the piece [m2/s]; or at its end [Pa]
};

/// What flowed during a piece of an interval, per unit thickness.
struct PieceOfFlow {
  double end = 0;                 ///< [s]
  std::vector<double> taken;      ///< by both faces of every cell [m]
  std::vector<double> brought;    ///< by every perforation [m2]
  std::vector<double> last_rate;  ///< of every perforation at `end` [m2/s]
};

/// A flow solver with one fluid content per node: everything of the contract but how the fluid moves. What
/// derives from it moves the fluid through one piece of time.
class CellSolver : public FlowSolver {
 public:
  [[nodiscard]] StateKept state_kept() const override { return StateKept::own_and_neutral; }
  void join(const FlowCase& flow_case) override;
  void insert(const Insertion& insertion, const FractureNetwork& network) override;
  FlowAnswer advance(const CouplingInterval& interval) override;
  [[nodiscard]] std::vector<FlowField> report() const override;
  [[nodiscard]] std::vector<std::byte> save() const override;
  void restore(std::span<const std::byte> state, const FractureNetwork& network) override;
  [[nodiscard]] NeutralFlowState neutral_state() const override;
  void take_up(const NeutralFlowState& state, const FractureNetwork& network) override;

 protected:
  struct Ends {
    std::size_t a, b;
  };

  /// The topology has changed, or is known for the first time.
  virtual void prepare() = 0;
  /// Moves the fluid from state_.time to `end`, within one stage, and keeps the piece. laws_ are those of the
  /// begin. @returns sub-steps or iterations
  virtual int cover(double end) = 0;

  /// The laws of all cells at `time` [s].
  void set_laws(double time);
  /// What the well does from `begin` to `end`, within the stage in force [s].
  [[nodiscard]] WellDemand well_demand(double begin, double end) const;
  /// Leak-off that a cell has not yet been asked for, up to `time` [m].
  [[nodiscard]] double leak_off_demand(std::size_t cell, double time) const;
  /// Books what a piece moved: leaked, the sums of the ledger, rate and well pressure. Content, pressure and
  /// flux have been set.
  void keep_piece(const PieceOfFlow& piece);

  FlowCase case_;
  CellState state_;
  std::vector<CellLaw> laws_;
  const CouplingInterval* interval_ = nullptr;  ///< while advance is at work
  std::vector<Ends> ends_;                      ///< of every segment
  std::vector<double> segment_length_;          ///< [m]
  std::vector<double> length_;                  ///< lumped, of every cell [m]
  std::vector<std::size_t> perforations_;       ///< their cells

 private:
  void take_network(const FractureNetwork& network);
  void take_segments(const FractureNetwork& network);
  /// Tips have entered `cells` at their exposure times, coming from their neighbours; sweeps of cells that
  /// are no tips have ended at `latest` [s].
  void sweep(std::vector<std::size_t> cells, const FractureNetwork& network, double latest);
  void start();
  void reset_content();
  void enter_stage();
  [[nodiscard]] double in_fractures() const;
  [[nodiscard]] FluidLedger ledger() const;
  [[nodiscard]] FlowAnswer answer(int iterations) const;

  Schedule schedule_;
};

}  // namespace fissura::cells
