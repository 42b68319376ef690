// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/check.hpp"

#include <iterator>

#include "coupler/conformance/physics_checks.hpp"

namespace fissura::coupler::conformance {

std::vector<Check> all_checks() {
  std::vector<Check> all;
  for (const auto& subject : {
           handshake_checks,
           order_checks,
           insertion_checks,
           topology_checks,
           report_checks,
           state_checks,
           neutral_checks,
           physics_checks,
           damage_checks,
           deadline_checks,
       }) {
    std::vector<Check> checks = subject();
    std::move(checks.begin(), checks.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace fissura::coupler::conformance
