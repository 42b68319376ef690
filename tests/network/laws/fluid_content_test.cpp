// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/fluid_content.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace fissura::network;

namespace {

std::vector<ContentLaw> laws() {
  return {
      {1e-3, 1e-10, 5e6, 2e9, 1e-5, Faces::separated},
      {1e-3, 1e-9, 5e6, 2e9, 1e-5, Faces::separated},
      {0, 1e-10, 5e6, 2e9, 1e-5, Faces::in_contact},
      {1e-5, 1e-10, 5e6, 2e9, 1e-5, Faces::in_contact},
      {0, 0, 0, 2e9, 1e-5, Faces::separated},
      {5e-5, 1e-10, 5.5e6, 2e9, 1e-5, Faces::in_contact, {1e-11, 2e6, 5.5e6}},
      {5e-4, 1e-10, 7e6, 2e9, 1e-5, Faces::separated, {1e-11, 2e6, 5.5e6}},
      {1e-5, 0, 5.5e6, 2e9, 1e-5, Faces::in_contact, {1e-11, 2e6, 5.5e6}},
  };
}

/// A natural fracture of 50 um that touches up to 9 MPa, found at 6 MPa.
ContentLaw touching_joint() {
  return {5e-5, 1e-10, 9e6, 2e9, 1e-5, Faces::in_contact, {1e-11, 6e6, 9e6}};
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
      const double compliance = law.compliance + law.joint.compliance;
      CHECK(node.content - previous <= 1.1e-3 * (1e6 * compliance * 1.01 + std::max(law.aperture, 1e-5)));
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

TEST_CASE("content: a touching joint is at its aperture at formation pressure and opens by c_s beyond it",
          "[network][laws]") {
  const ContentLaw law = touching_joint();
  CHECK(hydraulic_aperture(law, 6e6) == 5e-5);
  CHECK(hydraulic_aperture(law, 8e6) == Approx(7e-5).epsilon(1e-12));
  CHECK(hydraulic_aperture(law, 3e6) == Approx(2e-5).epsilon(1e-12));
  CHECK(hydraulic_aperture(law, 0.5e6) == 0);
  CHECK(fluid_content(law, 8).content == Approx(7e-5 * (1 + 8e6 / 2e9)).epsilon(1e-12));
}

TEST_CASE("content: the structure is not told of the joint's own opening", "[network][laws]") {
  const ContentLaw law = touching_joint();
  CHECK(predicted_aperture(law, 8.9e6) == 5e-5);
  CHECK(predicted_aperture(law, 10e6) == Approx(5e-5 + 1e-10 * 1e6).epsilon(1e-12));
}

TEST_CASE(
    "content: where the contact opens the joint's own opening ends and stays, whether the faces touch or not",
    "[network][laws]") {
  ContentLaw law = touching_joint();
  CHECK(hydraulic_aperture(law, 10e6) == Approx(5e-5 + 3e-5 + 1e-4).epsilon(1e-12));
  const double at_opening = hydraulic_aperture(law, 9e6);
  law.faces = Faces::separated;
  CHECK(hydraulic_aperture(law, 9e6) == at_opening);
  CHECK(joint_opening(law.joint, 12e6) == Approx(3e-5).epsilon(1e-12));
}

TEST_CASE("content: the places where it turns steeper are found from either side", "[network][laws]") {
  ContentLaw law = touching_joint();
  // Below 1 MPa the aperture is zero; beyond 9 MPa the rock gives way, ten times as much as the joint.
  CHECK(first_steepening(law, 0.2, 20).value() == Approx(1).epsilon(1e-9));
  CHECK(first_steepening(law, 2, 20).value() == Approx(9).epsilon(1e-12));
  CHECK_FALSE(first_steepening(law, 2, 8).has_value());
  CHECK_FALSE(first_steepening(law, 20, 0).has_value());
  law.compliance = 0;
  CHECK(first_steepening(law, 20, 3).value() == Approx(9).epsilon(1e-12));
  law.joint.compliance = 0;
  CHECK_FALSE(first_steepening(law, 0, 20).has_value());
  const ContentLaw open{1e-3, 1e-9, 5e6, 2e9, 1e-5, Faces::separated};
  CHECK(first_steepening(open, 1, 20).value() == Approx(4).epsilon(1e-12));
}
