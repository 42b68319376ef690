// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/carter.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace fissura::reference;

TEST_CASE("Carter balance: published areas of a fracture of 2 mm fed with 1e-3 m2/s", "[reference][carter]") {
  const auto area = [](double coefficient, double spurt, double time) {
    return carter::face_area(1e-3, 2e-3, coefficient, spurt, time);
  };
  CHECK(area(1e-6, 0, 100) == Approx(49.34110).epsilon(1e-6));
  CHECK(area(1e-6, 1e-4, 1000) == Approx(437.69492).epsilon(1e-6));
  CHECK(area(1e-5, 0, 1000) == Approx(347.58861).epsilon(1e-6));
  CHECK(area(1e-5, 1e-4, 100) == Approx(40.48248).epsilon(1e-6));
  CHECK(area(5e-5, 0, 100) == Approx(29.33476).epsilon(1e-6));
  CHECK(area(5e-5, 1e-4, 1000) == Approx(145.80651).epsilon(1e-6));
}

TEST_CASE("Carter balance: injected volume is stored or lost", "[reference][carter]") {
  const double rate = 1e-3, width = 2e-3, coefficient = 5e-5, spurt = 1e-4, time = 400;
  const auto area = [&](double t) { return carter::face_area(rate, width, coefficient, spurt, t); };
  double lost = 0;
  const int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const double begin = time * i / steps, end = time * (i + 1) / steps;
    const double exposed = i == 0 ? area(end) : area(end) - area(begin);
    lost += 2 * exposed * carter::lost_through_face(coefficient, spurt, time - (begin + end) / 2);
  }
  // The midpoint rule in time.
  CHECK(width * area(time) + lost == Approx(rate * time).epsilon(1e-4));
}
