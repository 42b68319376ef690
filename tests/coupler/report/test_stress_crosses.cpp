// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "coupler/report/principal_stress.hpp"
#include "coupler/report/stress_crosses.hpp"

using namespace fissura::coupler;

TEST_CASE("the greatest compression is found at any angle", "[coupler][report]") {
  for (const double angle : {-1.2, -0.3, 0.0, 0.7, std::numbers::pi / 2}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const PrincipalStress found =
        principal_stress(-15 * c * c - 10 * s * s, -15 * s * s - 10 * c * c, -5 * c * s);
    CHECK(found.greatest_compression == Approx(-15));
    CHECK(found.least_compression == Approx(-10));
    CHECK(std::abs(std::sin(found.angle - angle)) < 1e-12);
  }
  CHECK(principal_stress(-10, -10, 0).angle == 0);
}

TEST_CASE("views show the tip, the fracture and the domain, and stay within it", "[coupler][report]") {
  const View domain{"whole domain", -10, 10, -10, 10};
  const std::vector<View> views = views_of({-2, 0, 0, 0, 6, 1}, domain);
  REQUIRE(views.size() == 3);
  // (6, 1) and (-2, 0) are equally far from the middle; the first of them is taken.
  CHECK((views[0].west + views[0].east) / 2 == Approx(-2));
  CHECK(views[1].west < -2);
  CHECK(views[1].east > 6);
  for (const View& view : views)
    CHECK((view.west >= -10 && view.east <= 10 && view.south >= -10 && view.north <= 10));
  CHECK(views_of({}, domain).size() == 1);
}
