// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/interval_control.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr double stable_step = 1e-3, element_size = 0.5;

Coupling some_limits() {
  Coupling limits;
  limits.minimum_steps = 10;
  limits.maximum_steps = 100;
  limits.front_fraction = 0.02;
  limits.drift_tolerance = 1e-3;
  limits.maximum_interval = 0;
  return limits;
}

struct Control {
  explicit Control(const Coupling& limits) : control(limits, element_size) { control.start(stable_step); }

  /// One interval further, at a half length that stands still unless it is said to move.
  void observe(double drift, double half_length = 10, bool inlet_closed = false, double step = stable_step) {
    time += control.proposal();
    control.observe({time, drift, step, half_length, inlet_closed});
  }

  IntervalControl control;
  double time = 0;
};

}  // namespace

TEST_CASE("a run begins with the fewest steps per interval", "[coupler][scheme]") {
  CHECK(Control(some_limits()).control.proposal() == 10 * stable_step);
}

TEST_CASE("an interval stays between the fewest and the most explicit steps, whatever the drift",
          "[coupler][scheme]") {
  Control calm(some_limits()), wild(some_limits());
  for (int k = 0; k < 50; ++k) {
    calm.observe(0);
    wild.observe(1);
    CHECK(calm.control.proposal() <= 100 * stable_step);
    CHECK(wild.control.proposal() >= 10 * stable_step);
  }
  CHECK(calm.control.proposal() == 100 * stable_step);
  CHECK(wild.control.proposal() == 10 * stable_step);
}

TEST_CASE("the limits follow the stable step of the structure", "[coupler][scheme]") {
  Control control(some_limits());
  for (int k = 0; k < 50; ++k) control.observe(0);
  control.observe(0, 10, false, stable_step / 8);
  CHECK(control.control.proposal() == 100 * stable_step / 8);
}

TEST_CASE("a limit in seconds goes before the number of steps", "[coupler][scheme]") {
  Coupling limits = some_limits();
  limits.maximum_interval = 0.023;
  Control control(limits);
  for (int k = 0; k < 50; ++k) control.observe(0);
  CHECK(control.control.proposal() == 0.023);
}

TEST_CASE("intervals shrink with the square root of the drift and settle where it is the tolerated one",
          "[coupler][scheme]") {
  Control control(some_limits());
  // 50 ms at first, then a drift that grows with the square of the interval and is the tolerated one at 40
  // ms.
  while (control.control.proposal() < 0.05) control.observe(0);
  for (int k = 0; k < 200; ++k) {
    const double relative = control.control.proposal() / 0.04;
    control.observe(1e-3 * relative * relative);
  }
  // 0.9 of it: the caution of the rule.
  CHECK(control.control.proposal() == Approx(0.9 * 0.04).epsilon(1e-6));
}

TEST_CASE("one bad interval at most halves the next, one good one lengthens it by less than a third",
          "[coupler][scheme]") {
  Control control(some_limits());
  while (control.control.proposal() < 0.05) control.observe(0);
  const double before = control.control.proposal();
  control.observe(1);
  CHECK(control.control.proposal() == Approx(before / 2).epsilon(1e-14));
  control.observe(1e-12);
  CHECK(control.control.proposal() == Approx(before / 2 * 1.3).epsilon(1e-14));
}

TEST_CASE("the front crosses only a fraction of an element per interval", "[coupler][scheme]") {
  Coupling limits = some_limits();
  limits.maximum_steps = 10000;
  Control control(limits);
  // A front of 0.4 m/s, seen every time it has crossed an element.
  for (int k = 0; k < 2000; ++k)
    control.observe(0, 0.5 * std::floor((control.time + control.control.proposal()) * 0.4 / 0.5));
  CHECK(control.control.front_speed() == Approx(0.4).epsilon(0.15));
  CHECK(control.control.proposal() ==
        Approx(0.02 * element_size / control.control.front_speed()).epsilon(1e-12));
}

TEST_CASE("a front that has not moved has no speed and limits nothing", "[coupler][scheme]") {
  Control control(some_limits());
  for (int k = 0; k < 50; ++k) control.observe(0);
  CHECK(control.control.front_speed() == 0);
  CHECK(control.control.proposal() == 100 * stable_step);
}

TEST_CASE("a change of the pumping, or an inlet that closes, starts again with the shortest interval",
          "[coupler][scheme]") {
  Control control(some_limits());
  for (int k = 0; k < 50; ++k) control.observe(0);
  control.control.reset();
  CHECK(control.control.proposal() == 10 * stable_step);
  for (int k = 0; k < 50; ++k) control.observe(0);
  control.observe(0, 10, true);
  CHECK(control.control.proposal() == 10 * stable_step);
}
