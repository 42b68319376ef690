// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/flow_solver/pumping_schedule.hpp"
#include "network/exposure.hpp"

namespace fissura::network {

/// A sum that keeps what rounding takes away (Neumaier 1974), for sums over a whole run.
struct CompensatedSum {
  double sum = 0, correction = 0;

  void add(double term);
  [[nodiscard]] double value() const { return sum + correction; }
};

/// Cumulative volumes per unit thickness [m2].
struct LedgerSums {
  double in_place = 0;   ///< content at the start
  CompensatedSum found;  ///< pore fluid of nodes that joined saturated after the start
  CompensatedSum injected, leaked, reset;
};

/// What changes from step to step: everything that must be kept to go on from here. Arrays are in the order
/// of the graph's nodes, segments and perforations.
struct State {
  double time = 0;       ///< [s]
  bool started = false;  ///< the content of the start has been taken from the first apertures

  std::vector<double> content;   ///< m [m]: volume at zero pressure per area of face
  std::vector<double> pressure;  ///< p [Pa]
  std::vector<double> filled;    ///< 1, or [0, 1) where p = 0
  std::vector<double> leaked;    ///< v, taken by both faces so far, per trace length and thickness [m]
  std::vector<double> waived;    ///< leak-off demand let go while closed and dry [m]
  std::vector<unsigned char> has_been_filled;
  std::vector<Exposure> exposure;
  std::vector<unsigned char> joining;    ///< joined saturated, pore fluid not yet taken into the content
  std::vector<double> pore_content;      ///< content found at joining [m]
  std::vector<double> arrived;           ///< injected fluid that came in before the node was wetted [m]
  std::vector<double> contact_pressure;  ///< p_c of the joint law [Pa]
  std::vector<double> fluid_fraction;    ///< [n_nodes x n_fluids], by volume, rows sum to 1 [-]

  std::vector<double> flux;      ///< from a to b per unit thickness, of the last step [m2/s]
  std::vector<double> gradient;  ///< magnitude of the pressure gradient, of the last step [Pa/m]

  std::vector<double> perforation_rate;  ///< into the fracture, of the last step [m2/s]
  double well_pressure = 0;              ///< [Pa]
  double rate = 0;                       ///< of the well at `time` [m2/s]
  std::optional<std::size_t> stage;      ///< in force
  StageEntry stage_entry;

  LedgerSums ledger;
};

}  // namespace fissura::network
