// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupler/conformance/driver.hpp"

/// Balances of volume that physics checks share; each throws Deviation. For the thickness and the fluid of
/// flow_cases.
namespace fissura::coupler::conformance {

/// The ledger closes to the share of its largest entry that a run demands (flow_solvers.md 4).
inline constexpr double ledger_tolerance = 1e-10;
/// Sums of the same numbers in another order.
inline constexpr double rounding = 1e-12;
/// Pressures follow from contents as well as an iterative solution was solved: to the 1e-10 that the cases
/// ask for, times how much a stiff fluid magnifies it.
inline constexpr double solution_tolerance = 1e-6;

void require_closed(const FluidLedger& ledger);
/// Volume in the fractures as the answer's pressures, apertures and fillings have it [m3] (3c).
double volume_told(const Driver& driver, const FlowAnswer& answer);
/// The ledger closes, and what it says is in the fractures is there.
void require_balance(const Driver& driver, const FlowAnswer& answer);
/// The ledger says that `volume` [m3] was injected since the start, but for rounding of sums.
void require_injected(const FlowAnswer& answer, double volume);

}  // namespace fissura::coupler::conformance
