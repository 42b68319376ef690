// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/fluid_content.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace fissura::network;

namespace {

std::vector<ContentLaw> laws() {
  return {
      {1e-3, 1e-10, 5e6, 2e9, 1e-5, Faces::separated}, {1e-3, 1e-9, 5e6, 2e9, 1e-5, Faces::separated},
      {0, 1e-10, 5e6, 2e9, 1e-5, Faces::in_contact},   {1e-5, 1e-10, 5e6, 2e9, 1e-5, Faces::in_contact},
      {0, 0, 0, 2e9, 1e-5, Faces::separated},
  };
}

}  // namespace

TEST_CASE("content: compliance acts on the pressure increment and stores no fluid", "[network][laws]") {
  const ContentLaw law{1e-3, 1e-10, 5e6, 2e9, 1e-5, Faces::separated};
  const NodeContent node = fluid_content(law, 5);
  CHECK(node.aperture == 1e-3);
  CHECK(node.content == Approx(1e-3 * (1 + 5e6 / 2e9)).epsilon(1e-15));
  CHECK(hydraulic_aperture(law, 6e6) == Approx(1.1e-3).epsilon(1e-14));
}

TEST_CASE("content: closed faces yield only to pressure beyond the reference", "[network][laws]") {
  const ContentLaw law{1e-5, 1e-10, 5e6, 2e9, 1e-5, Faces::in_contact};
  CHECK(hydraulic_aperture(law, 0) == 1e-5);
  CHECK(hydraulic_aperture(law, 4.9e6) == 1e-5);
  CHECK(hydraulic_aperture(law, 6e6) == Approx(1.1e-4).epsilon(1e-14));
}

TEST_CASE("content: an aperture never falls below zero", "[network][laws]") {
  const ContentLaw law{1e-3, 1e-9, 5e6, 2e9, 1e-5, Faces::separated};
  CHECK(hydraulic_aperture(law, 0) == 0);
  CHECK(hydraulic_aperture(law, 3.9e6) == 0);
}

TEST_CASE("content: continuous and never falling from unmet demand through dry and part-filled to filled",
          "[network][laws]") {
  for (const ContentLaw& law : laws()) {
    double previous = fluid_content(law, -5).content;
    for (int k = -4999; k <= 12000; ++k) {
      const double u = k * 1e-3;
      const NodeContent node = fluid_content(law, u);
      CHECK(node.content >= previous - 1e-18);
      // No jump: one step of u at the steepest slope.
      CHECK(node.content - previous <= 1.1e-3 * (1e6 * law.compliance * 1.01 + std::max(law.aperture, 1e-5)));
      previous = node.content;
    }
  }
}

TEST_CASE("content: regular even for zero aperture", "[network][laws]") {
  const ContentLaw law{0, 1e-10, 5e6, 2e9, 1e-5, Faces::in_contact};
  CHECK(fluid_content(law, -1e-6).content_slope > 0);
  CHECK(fluid_content(law, 0).content == 0);
  CHECK(fluid_content(law, unfilled_unknown(law, -1e-6)).content == Approx(-1e-6).epsilon(1e-12));
}

TEST_CASE("content: not bounded below, so that leak-off may ask for more than there is", "[network][laws]") {
  const ContentLaw law{1e-3, 0, 0, 2e9, 1e-5, Faces::separated};
  CHECK(fluid_content(law, -3).content == Approx(-2e-3).epsilon(1e-15));
  CHECK(fluid_content(law, -3).pressure == 0);
}

TEST_CASE("content: slopes are the derivatives", "[network][laws]") {
  for (const ContentLaw& law : laws())
    for (const double u : {-2.5, -0.3, 0.7, 4.2, 5.9, 30.0}) {
      CAPTURE(u, law.aperture, law.compliance);
      const double step = 1e-4;
      const NodeContent node = fluid_content(law, u);
      const NodeContent above = fluid_content(law, u + step), below = fluid_content(law, u - step);
      // Central differences of a quadratic are exact up to rounding of the contents.
      CHECK((above.content - below.content) / (2 * step) ==
            Approx(node.content_slope).epsilon(1e-8).margin(1e-13));
      CHECK((above.pressure - below.pressure) / (2 * step) == Approx(node.pressure_slope).epsilon(1e-8));
    }
}
