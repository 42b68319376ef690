// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "network/graph.hpp"
#include "network/model.hpp"
#include "network/step.hpp"

namespace fissura::network {

/// The balance of every node and of the well at one set of unknowns, and its Jacobian.
struct Assembly {
  std::vector<double> residual;  ///< nodes, then the well [m2]
  std::vector<double> jacobian;  ///< values in the order of the graph's pattern [m2]
  std::vector<double> pressure;  ///< of the nodes [Pa]
  double well_pressure = 0;      ///< [Pa]
  double imbalance = 0;          ///< sum of |residual| [m2]
  double moved = 0;      ///< content stored, lost and injected in the step, as a sum of magnitudes [m2]
  double round_off = 0;  ///< imbalance that rounding alone can leave [m2]
};

/// Balance of the step (docs/protocol.md, section 3), per unit thickness:
///   R_i = l_i (M_i(u_i) + Lambda_i - m_i) - dt [ sum_j T_ij (p_j - p_i) + q_i ],      q_i = WI (p_w - p_i)
///   R_w = dt [ sum_i q_i - Q ]           with the rate given
///   R_w = dt n WI [ p_w - p_given ]      with the pressure given, n perforations
/// @param content  m of the nodes at the begin of the step [m]
/// @param unknown  u of the nodes, then p_w / pressure_scale
void assemble(const Model& model, const Graph& graph, const Step& step, std::span<const double> content,
              std::span<const double> unknown, Assembly& assembly);

}  // namespace fissura::network
