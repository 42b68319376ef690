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

// Steady flow from a well to a basin without pressure: what is pumped goes through every segment, whatever
// the steps in time, so that each drop of pressure is that of one conductance.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 3.2";
constexpr double rate = 1e-4;
constexpr double flux = rate / water::thickness;  // per unit thickness [m2/s]
constexpr StillRock rigid{.aperture = 1e-4};

/// Drop of pressure along `length` by the cubic law [Pa].
double drop(double through, double aperture, double mu, double length) {
  return 12 * mu * through * length / std::pow(aperture, 3);
}

/// `drops` are those of the segments from west to east.
void require_pressures(const OpenSlit& slit, const std::vector<double>& drops) {
  double expected = 0;
  for (std::size_t i = OpenSlit::nodes - 1; i-- > 0;) {
    expected += drops[i];
    require_ratio(fmt::format("pressure of node {} [Pa]", i), slit.last.pressure[i], expected,
                  solution_tolerance);
  }
  require_close("pressure of the basin, which never fills [Pa]", slit.last.pressure.back(), 0, 0);
  require_balance(slit.driver, slit.last);
}

std::string first_of(const OpenSlit& slit, const std::vector<double>& drops) {
  double sum = 0;
  for (const double each : drops) sum += each;
  return fmt::format("{:.7g} Pa at the well, {:.7g} Pa by hand", slit.last.pressure.front(), sum);
}

std::vector<double> equal_drops(double each) {
  return std::vector<double>(OpenSlit::nodes - 1, each);
}

std::string steady(const Candidate& candidate, double mu) {
  Case run_case = water_case(rate);
  run_case.fluids.front().consistency_index = mu;
  OpenSlit slit(candidate, run_case, rigid);
  slit.settle();
  const std::vector<double> drops = equal_drops(drop(flux, rigid.aperture, mu, OpenSlit::spacing));
  require_pressures(slit, drops);
  return first_of(slit, drops);
}

std::string plain_slit(const Candidate& candidate) {
  return steady(candidate, water::viscosity);
}

std::string thinner(const Candidate& candidate) {
  return steady(candidate, water::viscosity / 3);
}

std::string wedge(const Candidate& candidate) {
  OpenSlit slit(candidate, water_case(rate), rigid);
  for (std::size_t i = 0; i < OpenSlit::nodes; ++i)
    slit.asked.aperture[i] = (1 - 0.12 * static_cast<double>(i)) * rigid.aperture;
  slit.settle();
  std::vector<double> drops;
  for (std::size_t i = 0; i + 1 < OpenSlit::nodes; ++i)
    drops.push_back(drop(flux, (slit.asked.aperture[i] + slit.asked.aperture[i + 1]) / 2, water::viscosity,
                         OpenSlit::spacing));
  require_pressures(slit, drops);
  return first_of(slit, drops);
}

/// Apertures of arms differ from those of the nodes, and along the segment: which end is which shows only in
/// that each end is lifted to the floor by itself, which `floor` tries.
std::string arms(const Candidate& candidate) {
  OpenSlit slit(candidate, water_case(rate), rigid);
  const std::vector<NetworkSegment>& segments = slit.driver.network().segments();
  std::vector<double> drops;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    slit.asked.arm_aperture_a.push_back((1.1 + 0.05 * static_cast<double>(s)) * rigid.aperture);
    slit.asked.arm_aperture_b.push_back((0.8 + 0.02 * static_cast<double>(s)) * rigid.aperture);
    drops.push_back(drop(flux, (slit.asked.arm_aperture_a[s] + slit.asked.arm_aperture_b[s]) / 2,
                         water::viscosity, segments[s].length));
  }
  slit.settle();
  require_pressures(slit, drops);
  const std::string obtained = first_of(slit, drops);
  // The arms of this interval count, not those of the last: twice as wide, an eighth of the drops. One step
  // of backward Euler, ten thousand time constants of the rigid slit long, leaves less than a hundredth.
  double sum = 0;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    slit.asked.arm_aperture_a[s] *= 2;
    slit.asked.arm_aperture_b[s] *= 2;
    sum += drops[s] / 8;
  }
  slit.advance(1);
  require_ratio("pressure at the well an interval after all arms are twice as wide [Pa]",
                slit.last.pressure.front(), sum, 0.01);
  return obtained;
}

std::string floor(const Candidate& candidate) {
  constexpr double floor_aperture = 5e-5, narrow = 1e-6;
  Case run_case = water_case(rate);
  run_case.network.minimum_aperture = floor_aperture;
  OpenSlit slit(candidate, run_case, rigid);
  const std::size_t segments = slit.driver.network().segments().size();
  slit.asked.arm_aperture_a.assign(segments, rigid.aperture);
  slit.asked.arm_aperture_b.assign(segments, rigid.aperture);
  std::vector<double> drops = equal_drops(drop(flux, rigid.aperture, water::viscosity, OpenSlit::spacing));
  slit.asked.arm_aperture_a[1] = narrow;
  drops[1] = drop(flux, (floor_aperture + rigid.aperture) / 2, water::viscosity, OpenSlit::spacing);
  slit.asked.arm_aperture_b[2] = 0;
  drops[2] = drops[1];
  slit.asked.arm_aperture_a[3] = slit.asked.arm_aperture_b[3] = narrow;
  drops[3] = drop(flux, floor_aperture, water::viscosity, OpenSlit::spacing);
  slit.settle();
  require_pressures(slit, drops);
  return first_of(slit, drops);
}

/// Twice the length of one segment, twice its drop.
std::string length_of_segment(const Candidate& candidate) {
  constexpr double longer = 2;
  Insertion first = straight_slit(OpenSlit::nodes - 1, OpenSlit::spacing, 0);
  first.new_segments[2].length *= longer;
  StillScene scene(candidate, water_case(rate), first, rigid);
  scene.advance(1e-6);
  scene.insert(basin(scene.driver.network(), OpenSlit::nodes - 2, OpenSlit::spacing, scene.time));
  scene.advance_many(20, 0.05);
  const double plain = drop(flux, rigid.aperture, water::viscosity, OpenSlit::spacing);
  for (std::size_t s = 0; s + 2 < OpenSlit::nodes; ++s)
    require_ratio(fmt::format("drop of pressure along segment {} [Pa]", s),
                  scene.last.pressure[s] - scene.last.pressure[s + 1], s == 2 ? longer * plain : plain,
                  solution_tolerance);
  return fmt::format("{:.6g} Pa along 0.5 m, {:.6g} Pa along {:g} m",
                     scene.last.pressure[0] - scene.last.pressure[1],
                     scene.last.pressure[2] - scene.last.pressure[3], longer * OpenSlit::spacing);
}

/// Three ways from one node, each of its own length and aperture to its own basin: what comes in goes out,
/// by the conductances.
std::string kirchhoff(const Candidate& candidate) {
  constexpr std::size_t middle = 2;
  constexpr double spacing = OpenSlit::spacing;
  StillScene scene(candidate, water_case(rate), straight_slit(2 * middle + 1, spacing, middle), rigid);
  scene.insert(junction(scene.driver.network(), middle, middle, spacing, scene.time));
  const std::size_t north = scene.driver.network().nodes().size() - 1;
  scene.asked.aperture[north] = scene.asked.aperture[north - 1] = 0.8 * rigid.aperture;
  scene.advance(1e-6);
  for (const std::size_t end : {std::size_t{0}, 2 * middle, north})
    scene.insert(basin(scene.driver.network(), end, spacing * (end == 0 ? 3 : 1), scene.time));
  scene.advance_many(30, 0.05);

  const std::vector<double>& pressure = scene.last.pressure;
  const std::vector<NetworkSegment>& segments = scene.driver.network().segments();
  std::vector<double> balance(pressure.size(), 0.0);
  double conductance = 0;
  for (const NetworkSegment& segment : segments) {
    const std::size_t a = scene.driver.network().index_of(segment.node_a),
                      b = scene.driver.network().index_of(segment.node_b);
    const double through =
        (pressure[a] - pressure[b]) /
        drop(1, (scene.asked.aperture[a] + scene.asked.aperture[b]) / 2, water::viscosity, segment.length);
    balance[a] -= through;
    balance[b] += through;
  }
  balance[middle] += flux;
  double arriving = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (i > north)
      arriving += balance[i];
    else
      require_close(fmt::format("what comes to node {} less what leaves it [m2/s]", i), balance[i], 0,
                    solution_tolerance * flux);
  }
  require_ratio("what comes to the three basins [m2/s]", arriving, flux, solution_tolerance);
  const double west = 1 / drop(1, rigid.aperture, water::viscosity, (middle + 3) * spacing);
  const double east = 1 / drop(1, rigid.aperture, water::viscosity, (middle + 1) * spacing);
  const double first_segment = drop(1, 0.9 * rigid.aperture, water::viscosity, spacing);
  const double others = drop(1, 0.8 * rigid.aperture, water::viscosity, spacing) + first_segment;
  conductance = west + east + 1 / (first_segment + others);
  require_ratio("pressure of the junction [Pa]", pressure[middle], flux / conductance, solution_tolerance);
  return fmt::format("{:.7g} Pa at the junction, {:.7g} Pa by hand", pressure[middle], flux / conductance);
}

}  // namespace

std::vector<Check> cubic_law_checks() {
  const std::set<std::string> flow{claims::viscous_flow}, growth{"insert"};
  return {
      {.name = "cubic_law.steady",
       .contract = contract,
       .expected = "steady flow falls by 12 mu q L / e^3 along each segment",
       .physics = flow,
       .capabilities = growth,
       .carry_out = plain_slit},
      {.name = "cubic_law.viscosity",
       .contract = contract,
       .expected = "a third of the viscosity, a third of the pressure",
       .physics = flow,
       .capabilities = growth,
       .carry_out = thinner},
      {.name = "cubic_law.wedge",
       .contract = contract,
       .expected = "a wedge is a series of conductances, each of the mean aperture of its ends",
       .physics = flow,
       .capabilities = growth,
       .carry_out = wedge},
      {.name = "cubic_law.arms",
       .contract = contract,
       .expected = "conductances are of the apertures of the arms, where they are sent",
       .physics = flow,
       .capabilities = growth,
       .carry_out = arms},
      {.name = "cubic_law.floor",
       .contract = contract,
       .expected = "each end of an arm is lifted to minimum_aperture, by itself, before the mean is taken",
       .physics = flow,
       .capabilities = growth,
       .carry_out = floor},
      {.name = "cubic_law.length",
       .contract = contract,
       .expected = "the conductance is that of the length of the segment, not of the distance of its nodes",
       .physics = flow,
       .capabilities = growth,
       .carry_out = length_of_segment},
      {.name = "cubic_law.junction",
       .contract = contract,
       .expected = "what comes to a junction leaves it, shared by the conductances of its arms",
       .physics = flow,
       .capabilities = growth,
       .carry_out = kirchhoff},
  };
}

}  // namespace fissura::coupler::conformance
