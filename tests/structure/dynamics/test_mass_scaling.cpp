// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/mass_scaling.hpp"
#include "tests/fakes/structure/shale_case.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

const Rock rock = shale_case().rock;

Dynamics controls() {
  Dynamics dynamics;
  dynamics.loading_ratio = 0.05;
  dynamics.event_loading_ratio = 0.2;
  dynamics.initial_mass_scale = 10;
  dynamics.maximum_mass_scale = 1e5;
  return dynamics;
}

int updates_until_steady(MassScaling& scaling, double time, double half_length) {
  int updates = 0;
  while (scaling.update(time, half_length)) ++updates;
  return updates;
}

}  // namespace

TEST_CASE("mass scaling: shear waves cross the fracture four times in the given share of the time",
          "[structure][dynamics]") {
  const double ratio = 0.05, time = 300, half_length = 66;
  const double scale = quasi_static_mass_scale(rock, ratio, time, half_length);
  const double scaled_speed = std::sqrt(rock.shear_modulus() / (scale * rock.density));
  CHECK(4 * half_length / scaled_speed == Approx(ratio * time).epsilon(1e-12));
  CHECK(scale == Approx(1.72e4).epsilon(5e-3));  // printed to two digits for this run: 1.7e4
}

TEST_CASE("mass scaling: grows by at most one half per interval, and not for less than a fifth",
          "[structure][dynamics]") {
  MassScaling scaling(controls(), rock);
  REQUIRE(scaling.scale() == 10);
  const double half_length = 10,
               steady_time = 4 * half_length * std::sqrt(1000 * rock.density / rock.shear_modulus()) / 0.05;
  CHECK(scaling.update(steady_time, half_length));
  CHECK(scaling.scale() == Approx(15).epsilon(1e-12));
  while (scaling.update(steady_time, half_length)) CHECK(scaling.scale() <= 1000 * (1 + 1e-12));
  CHECK(scaling.scale() > 1000 / 1.2);
  const double before = scaling.scale();
  CHECK_FALSE(scaling.update(steady_time * std::sqrt(before / 1000 * 1.19), half_length));
  CHECK(scaling.scale() == before);
}

TEST_CASE("mass scaling: keeps to the limits of the case", "[structure][dynamics]") {
  MassScaling scaling(controls(), rock);
  CHECK_FALSE(scaling.update(1e-3, 100));
  CHECK(scaling.scale() == 10);
  updates_until_steady(scaling, 1e9, 10);
  CHECK(scaling.scale() <= 1e5);
  CHECK(scaling.scale() > 1e5 / 1.2);
}

TEST_CASE("mass scaling: a pump event drops the masses at once and lets them come back",
          "[structure][dynamics]") {
  const double half_length = 100, event_time = 300, ramp = 2;
  MassScaling scaling(controls(), rock);
  updates_until_steady(scaling, event_time, half_length);
  const double pumping = scaling.scale();
  scaling.note_pump_event(event_time, ramp);
  CHECK(scaling.update(event_time + 0.01, half_length));
  const double dropped = std::max(1.0, quasi_static_mass_scale(rock, 0.2, ramp, half_length));
  CHECK(scaling.scale() == Approx(dropped).epsilon(1e-12));
  CHECK(dropped < pumping / 100);
  CHECK(dropped > 1);
  CHECK_FALSE(scaling.update(event_time + 0.9 * ramp, half_length));
  updates_until_steady(scaling, event_time + 10, half_length);
  CHECK(scaling.scale() > dropped);
  CHECK(scaling.scale() <= quasi_static_mass_scale(rock, 0.2, 10, half_length) * (1 + 1e-12));
  updates_until_steady(scaling, event_time + 200, half_length);
  CHECK(scaling.scale() > pumping);
}
