// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "network/assemble.hpp"

namespace fissura::network {

/// What flows during a step, of a converged solution; per unit thickness.
struct Flow {
  std::vector<double> flux;              ///< of every segment, from a to b [m2/s]
  std::vector<double> gradient;          ///< magnitude, of every segment [Pa/m]
  std::vector<double> perforation_rate;  ///< into the fracture [m2/s]
  std::vector<double> inflow;            ///< of every node, segments and perforations together [m2/s]
};

/// Each flux leaves one node as exactly what enters the other. With the rate given the perforations get
/// exactly that rate together, and a single one gets it whole.
void flow_of(const Model& model, const Graph& graph, const Step& step, const Assembly& solution, Flow& flow);

}  // namespace fissura::network
