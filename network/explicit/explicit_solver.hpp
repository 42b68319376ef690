// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "network/cells/cell_solver.hpp"

namespace fissura::explicit_flow {

/// Share of the greatest stable sub-step that is taken.
inline constexpr double stable_share = 0.9;

/// A cell whose own bound is below this share of the median cell's does not bind the sub-step, but is kept in
/// balance.
inline constexpr double stiff_share = 0.01;

inline constexpr long maximum_sub_steps = 200'000'000;  ///< of one interval

/// Explicit finite volumes. In each sub-step dt, from the pressures at its begin,
///   l_i m_i' = l_i m_i + dt [ sum_j T_ij (p_j - p_i) + q_i ] - l_i taken_i,      p_i' from m_i'
/// with dt <= stable_share min_i l_i c_i / sum_j T_ij, c = dm/dp: README.md derives it. The well is taken
/// implicitly in its own node, q = WI (p_w - p'), and does not bind.
/// Cells below their opening pressure, with next to no storage, would bind by orders of magnitude more: their
/// pressure is the one at which storage and fluxes balance, found by sweeps over these cells (Gauss-Seidel),
/// the others standing still.
/// Content never falls below zero: where a cell would give more than it has and gets, all that leaves it is
/// cut by one factor, in the order of falling pressure.
class ExplicitSolver : public cells::CellSolver {
 public:
  [[nodiscard]] std::set<std::string> physics() const override;
  [[nodiscard]] nlohmann::json finish() const override;

 protected:
  void prepare() override;
  int cover(double end) override;

 private:
  struct Arm {
    std::size_t segment, cell;  ///< and the cell across
  };

  void begin_piece(double end);
  void end_piece(double begin, double end);
  void set_segment_apertures();
  void set_conductance();
  /// The bound above with the conductances as they stand [s]; sets below which content a cell is stiff.
  double stable_step();
  /// From state_.time to `end`; `progress` is the share of the piece that lies before `end`.
  void sub_step(double end, double progress);
  /// Fluxes at the pressures as they stand.
  void set_flux();
  /// What fluxes and perforations bring to every cell.
  void gather();
  /// Rates of the perforations, implicit in the pressure of their own cell: q = WI (p_w - p'),
  /// l c (p' - p) = dt (inflow + q).
  void feed(const cells::WellDemand& well, double dt);
  void find_stiff(double dt);
  void balance_stiff(double dt);
  void limit_outflow(double dt);

  std::vector<std::size_t> arm_begin_;
  std::vector<Arm> arms_;  ///< of all cells, one after the other

  // Memory of one piece; no state.
  cells::PieceOfFlow piece_;
  std::vector<double> content_at_begin_, moved_;
  std::vector<double> due_, asked_;  ///< leak-off of the piece, and by the end of the sub-step [m]
  std::vector<double> aperture_, conductance_, flux_, inflow_, conductance_sum_, slope_, threshold_, bound_;
  std::vector<double> gain_, there_;  ///< of every perforation
  std::vector<unsigned char> is_stiff_;
  std::vector<std::size_t> stiff_, order_;
  long sub_steps_ = 0;
};

}  // namespace fissura::explicit_flow
