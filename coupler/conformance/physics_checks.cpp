// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/physics_checks.hpp"

#include <iterator>

namespace fissura::coupler::conformance {

std::vector<Check> physics_checks() {
  std::vector<Check> all;
  for (const auto& subject : {
           storage_checks,
           filling_checks,
           cubic_law_checks,
           diffusion_checks,
           schedule_checks,
           well_checks,
           leak_off_checks,
           fluid_checks,
           natural_checks,
           balance_checks,
           transfer_checks,
           extreme_checks,
       }) {
    std::vector<Check> checks = subject();
    std::move(checks.begin(), checks.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace fissura::coupler::conformance
