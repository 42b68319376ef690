// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/model.hpp"

#include <algorithm>

namespace fissura::network {

bool Model::newtonian() const {
  return std::all_of(fluids.begin(), fluids.end(),
                     [](const FractureFluid& fluid) { return fluid.law.newtonian(); });
}

Model model_from_case(const FlowCase& flow_case) {
  Model model;
  for (const FlowFluid& fluid : flow_case.fluids)
    model.fluids.push_back({fluid.name, {fluid.consistency_index, fluid.power_index}, fluid.bulk_modulus});
  model.schedule = Schedule(flow_case.stages);
  model.leak_off = {flow_case.leak_off_coefficient, flow_case.spurt_volume};
  model.well_index = flow_case.well_index;
  model.thickness = flow_case.thickness;
  model.minimum_aperture = flow_case.minimum_aperture;
  model.tolerance = flow_case.tolerance;
  model.maximum_iterations = flow_case.maximum_iterations;
  model.dry = flow_case.dry;
  return model;
}

}  // namespace fissura::network
