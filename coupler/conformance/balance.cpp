// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/balance.hpp"

#include <algorithm>
#include <cmath>

#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/topologies.hpp"

namespace fissura::coupler::conformance {

void require_closed(const FluidLedger& ledger) {
  const double largest = std::max({std::abs(ledger.injected), ledger.in_place, ledger.found,
                                   ledger.in_fractures, ledger.leaked, std::abs(ledger.reset)});
  require_close("ledger.residual [m3]", ledger.residual(), 0, ledger_tolerance * largest);
}

double volume_told(const Driver& driver, const FlowAnswer& answer) {
  return water::thickness * integral(driver.network(), content_of(answer, water::bulk_modulus));
}

void require_balance(const Driver& driver, const FlowAnswer& answer) {
  require_closed(answer.ledger);
  require_ratio("volume that pressures, apertures and fillings make, as the ledger has it [m3]",
                volume_told(driver, answer), answer.ledger.in_fractures, solution_tolerance);
}

void require_injected(const FlowAnswer& answer, double volume) {
  require_close("ledger.injected [m3]", answer.ledger.injected, volume, rounding * std::abs(volume));
}

}  // namespace fissura::coupler::conformance
