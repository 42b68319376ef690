// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/pumped_slit.hpp"

#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/topologies.hpp"

namespace fissura::coupler::conformance {

Case pumped_case() {
  return water_case(PumpedSlit::rate);
}

CouplingInterval spring_interval(const Springs& springs, const FractureNetwork& network, double begin,
                                 double end, const std::vector<double>& pressure) {
  CouplingInterval interval = rigid_interval(network, begin, end, springs.aperture);
  interval.compliance.assign(interval.aperture.size(), springs.compliance);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    interval.reference_pressure[i] = pressure[i];
    interval.aperture[i] += springs.compliance * pressure[i];
  }
  return interval;
}

PumpedSlit::PumpedSlit(const Candidate& candidate)
    : PumpedSlit(candidate, pumped_case(), straight_slit(nodes, spacing, nodes / 2)) {}

PumpedSlit::PumpedSlit(const Candidate& candidate, const Case& run_case, const Insertion& first)
    : driver(candidate, run_case, first) {}

CouplingInterval PumpedSlit::next(double length) const {
  return spring_interval(springs, driver.network(), time, time + length, last.pressure);
}

const FlowAnswer& PumpedSlit::advance(double length) {
  const CouplingInterval interval = next(length);
  last = driver.advance(interval);
  time = interval.end;
  return last;
}

void PumpedSlit::advance_many(int count) {
  for (int k = 0; k < count; ++k) advance();
}

}  // namespace fissura::coupler::conformance
