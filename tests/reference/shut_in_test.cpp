// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/shut_in.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/reference/kgd_dontsov.hpp"
#include "tests/reference/sneddon.hpp"

using namespace fissura::reference;

namespace {

const Rock shale{32e9 / 0.96, std::sqrt(32e9 / 0.96 * 50)};
const ScaledParameters slickwater = scaled(shale, Treatment{1.67e-3, 1e-3, 0});

}  // namespace

TEST_CASE("shut-in: starts from the pumped fracture and ends at its arrest", "[reference][shut_in]") {
  const auto rows = shut_in::solve(slickwater, 5, {5.001, 3000}, {60, 0.05});
  const KgdState pumped = kgd_dontsov::state(slickwater, 5);
  CHECK(rows[0].half_length == Approx(pumped.half_length).epsilon(3e-3));
  // The kink of the aperture at the inlet rounds off within milliseconds.
  CHECK(rows[0].inlet_aperture == Approx(pumped.inlet_aperture).epsilon(1e-2));
  const auto arrest = sneddon::arrest(5e-3, shale.toughness, shale.plane_strain_modulus);
  CHECK(rows[1].half_length == Approx(arrest.half_length).epsilon(1e-4));
  CHECK(rows[1].inlet_aperture == Approx(arrest.aperture).epsilon(1e-4));
  CHECK(rows[1].inlet_net_pressure == Approx(arrest.net_pressure).epsilon(1e-4));
}

TEST_CASE("shut-in: agrees with a published run on fixed cells", "[reference][shut_in]") {
  const auto rows = shut_in::solve(slickwater, 5, {5.5, 6, 8, 10, 15, 20}, {60, 0.02});
  const double apertures[] = {0.506, 0.482, 0.429, 0.403, 0.369, 0.350};
  const double pressures[] = {0.696, 0.626, 0.498, 0.436, 0.365, 0.329};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // That run has cells of 0.25 m, first-order in length and hence in pressure.
    CHECK(rows[i].inlet_aperture * 1e3 == Approx(apertures[i]).epsilon(0.025));
    CHECK(rows[i].inlet_net_pressure * 1e-6 == Approx(pressures[i]).epsilon(0.04));
  }
}

TEST_CASE("shut-in: first order in the time step", "[reference][shut_in]") {
  const auto length = [](double fraction) {
    return shut_in::solve(slickwater, 5, {10}, {40, fraction}).front().half_length;
  };
  const double coarse = length(0.08), middle = length(0.04), fine = length(0.02);
  CHECK((coarse - middle) / (middle - fine) == Approx(2).epsilon(0.3));
  CHECK(middle == Approx(fine).epsilon(2e-3));
}
