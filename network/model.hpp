// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "common/flow_solver/flow_case.hpp"
#include "common/flow_solver/pumping_schedule.hpp"
#include "network/laws/carter_leak_off.hpp"
#include "network/laws/power_law_fluid.hpp"

namespace fissura::network {

struct FractureFluid {
  std::string name;
  PowerLaw law;
  double bulk_modulus = 0;  ///< K_f [Pa]
};

/// What never changes during a run. Volumes and rates are per unit thickness unless said otherwise.
struct Model {
  std::vector<FractureFluid> fluids;  ///< at least one, unless dry
  CarterLaw leak_off;
  Schedule schedule;
  double well_index = 0;        ///< WI of one perforation [m2/(s Pa)]
  double thickness = 0;         ///< H [m]
  double minimum_aperture = 0;  ///< floor in the conductivity only [m]
  double tolerance = 0;         ///< of the Newton residual, relative to the content moved [-]
  int maximum_iterations = 0;
  bool dry = false;  ///< nothing is ever pumped: no fracture holds fluid, and every pressure is zero

  [[nodiscard]] bool single_fluid() const { return fluids.size() == 1; }
  [[nodiscard]] bool newtonian() const;
};

Model model_from_case(const FlowCase& flow_case);

}  // namespace fissura::network
