// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/flow_cases.hpp"

namespace fissura::coupler::conformance {

Case water_case(double rate) {
  Case result;
  result.title = "conformance";
  result.time.end = 1000;
  result.domain = {.width = 1000, .height = 1000, .thickness = water::thickness};
  result.fluids = {{.name = "water",
                    .consistency_index = water::viscosity,
                    .power_index = 1,
                    .bulk_modulus = water::bulk_modulus}};
  result.injection.perforations = {{.name = "well", .position = {0, 0}, .aperture = 1e-5}};
  result.injection.well_index = water::well_index;
  result.network = {.minimum_aperture = 1e-5, .tolerance = 1e-10, .maximum_iterations = 100};
  add_stage(result, 0, rate);
  return result;
}

void add_stage(Case& run_case, double begin, double rate) {
  Stage stage;
  stage.begin = begin;
  stage.control = rate == 0 ? StageControl::shut_in : StageControl::rate;
  stage.rate = rate;
  if (rate != 0) stage.fluid = run_case.fluids.front().name;
  run_case.injection.stages.push_back(stage);
}

}  // namespace fissura::coupler::conformance
