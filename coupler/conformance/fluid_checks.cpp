// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupler/conformance/balance.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/physics_checks.hpp"
#include "coupler/conformance/still_rock.hpp"
#include "coupler/conformance/topologies.hpp"

// Fluids that are not water, and one that displaces another.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.5";
constexpr double rate = 1e-4;
constexpr double flux = rate / water::thickness;
constexpr StillRock rigid{.aperture = 1e-4};

struct PowerLaw {
  double consistency, index;
};

/// tau = K gamma^n between parallel plates: |dp/dx| = (2 K / e) (((2n + 1) / (3n)) (6 V / e))^n [Pa/m].
double gradient(const PowerLaw& fluid, double through, double aperture) {
  const double velocity = through / aperture;
  const double shear_rate = (2 * fluid.index + 1) / (3 * fluid.index) * 6 * velocity / aperture;
  return 2 * fluid.consistency / aperture * std::pow(shear_rate, fluid.index);
}

/// Steady flow at `share` of the rate through a slit that narrows by `taper` per node. A solver finds the
/// viscosity that follows the flow by iteration, within an interval or over some.
/// @returns the gradient at the well [Pa/m]
double require_power_law(const Candidate& candidate, const PowerLaw& fluid, double share, double taper) {
  constexpr double tolerance = 1e-3;
  Case run_case = water_case(share * rate);
  run_case.fluids = {{.name = "water",
                      .consistency_index = fluid.consistency,
                      .power_index = fluid.index,
                      .bulk_modulus = water::bulk_modulus}};
  OpenSlit slit(candidate, run_case, rigid);
  for (std::size_t i = 0; i < OpenSlit::nodes; ++i)
    slit.asked.aperture[i] *= 1 - taper * static_cast<double>(i);
  slit.settle();
  slit.settle();
  for (std::size_t i = 0; i + 1 < OpenSlit::nodes; ++i) {
    const double aperture = (slit.asked.aperture[i] + slit.asked.aperture[i + 1]) / 2;
    require_ratio(fmt::format("drop of pressure along segment {} at {:g} m3/s [Pa]", i, share * rate),
                  slit.last.pressure[i] - slit.last.pressure[i + 1],
                  gradient(fluid, share * flux, aperture) * OpenSlit::spacing, tolerance);
  }
  require_balance(slit.driver, slit.last);
  return (slit.last.pressure[0] - slit.last.pressure[1]) / OpenSlit::spacing;
}

std::string at_two_rates(const Candidate& candidate, const PowerLaw& fluid) {
  std::string obtained;
  for (const double share : {0.1, 0.5}) {
    const double measured = require_power_law(candidate, fluid, share, 0);
    obtained += fmt::format("{}{:.6g} Pa/m at {:g} m3/s, {:.6g} by hand", obtained.empty() ? "" : "; ",
                            measured, share * rate, gradient(fluid, share * flux, rigid.aperture));
  }
  return obtained;
}

std::string thinning(const Candidate& candidate) {
  return at_two_rates(candidate, {.consistency = 0.05, .index = 0.6});
}

std::string thickening(const Candidate& candidate) {
  return at_two_rates(candidate, {.consistency = 2e-5, .index = 1.3});
}

std::string tapered(const Candidate& candidate) {
  const double measured = require_power_law(candidate, {.consistency = 0.05, .index = 0.6}, 0.3, 0.1);
  return fmt::format("{:.6g} Pa/m at the well of a wedge", measured);
}

/// Steady flow of the first fluid, and of the second when the first has long left the slit. The basin is
/// wide, for all that is pumped; the arm to it is not.
std::string displaces(const Candidate& candidate) {
  constexpr double change = 5, thick = 3 * water::viscosity;
  Case run_case = water_case(rate);
  run_case.fluids.push_back(
      {.name = "gel", .consistency_index = thick, .power_index = 1, .bulk_modulus = water::bulk_modulus});
  run_case.injection.stages.push_back(
      {.begin = change, .control = StageControl::rate, .rate = rate, .fluid = "gel"});
  OpenSlit slit(candidate, run_case, {.aperture = rigid.aperture, .compliance = 1e-11});
  slit.asked.aperture.back() = 1e-2;
  const std::size_t segments = slit.driver.network().segments().size();
  slit.asked.arm_aperture_a.assign(segments, rigid.aperture);
  slit.asked.arm_aperture_b.assign(segments, rigid.aperture);
  const auto require_drops = [&](double viscosity, const char* fluid) {
    for (std::size_t s = 0; s < segments; ++s)
      require_ratio(fmt::format("drop of pressure along segment {}, through which {} flows [Pa]", s, fluid),
                    slit.last.pressure[s] - slit.last.pressure[s + 1],
                    12 * viscosity * flux * OpenSlit::spacing / std::pow(rigid.aperture, 3), 1e-4);
  };
  slit.advance_many(10, (change - slit.time) / 10);
  require_drops(water::viscosity, "water alone");
  const double before = slit.last.pressure.front();
  // A cell holds what is pumped in one or two seconds: of what was there, far less than a millionth is left.
  slit.advance_many(2, 1);
  require_within("pressure at the well while gel displaces water [Pa]", slit.last.pressure.front(),
                 1.01 * before, 2.99 * before);
  slit.advance_many(98, 1);
  // The segment to the basin is of both fluids, as the basin is, and still changes its pressure: some of the
  // flux is stored before it.
  for (std::size_t s = 0; s + 1 < segments; ++s)
    require_ratio(fmt::format("drop of pressure along segment {}, through which gel flows [Pa]", s),
                  slit.last.pressure[s] - slit.last.pressure[s + 1],
                  12 * thick * flux * OpenSlit::spacing / std::pow(rigid.aperture, 3), 1e-3);
  require_balance(slit.driver, slit.last);
  require_injected(slit.last, rate * slit.time);
  return fmt::format("{:.6g} Pa of water, {:.6g} Pa of gel three times as viscous", before,
                     slit.last.pressure.front());
}

}  // namespace

std::vector<Check> fluid_checks() {
  const std::set<std::string> needed{claims::viscous_flow, claims::power_law}, growth{"insert"};
  return {
      {.name = "power_law.thinning",
       .contract = contract,
       .expected = "the gradient of a shear-thinning fluid is that of parallel plates, at two rates",
       .physics = needed,
       .capabilities = growth,
       .carry_out = thinning},
      {.name = "power_law.thickening",
       .contract = contract,
       .expected = "so is that of a shear-thickening one",
       .physics = needed,
       .capabilities = growth,
       .carry_out = thickening},
      {.name = "power_law.wedge",
       .contract = contract,
       .expected = "in a wedge each segment's is of the mean aperture of its ends",
       .physics = needed,
       .capabilities = growth,
       .carry_out = tapered},
      {.name = "fluids.displaced",
       .contract = "flow_solvers.md 3.9",
       .expected = "the fluid of a later stage displaces the first, and the viscosity is of what is there",
       .physics = {claims::viscous_flow, claims::several_fluids},
       .capabilities = growth,
       .carry_out = displaces},
  };
}

}  // namespace fissura::coupler::conformance
