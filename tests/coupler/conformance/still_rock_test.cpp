// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/still_rock.hpp"

#include <array>
#include <catch2/catch.hpp>

#include "coupler/conformance/topologies.hpp"

using namespace fissura;
using namespace fissura::coupler::conformance;

namespace {

constexpr double bulk_modulus = 2e9;

}  // namespace

TEST_CASE("still rock: the pressure of a content is that under which a node holds it",
          "[coupler][conformance]") {
  // The root of a quadratic in doubles, in the form without a difference of equals.
  constexpr double rounding = 1e-12;
  for (const unsigned char closed : std::array<unsigned char, 2>{0, 1})
    for (const double compliance : {0.0, 1e-12, 1e-9})
      for (const double reference : {0.0, 1e5, 3e6})
        for (const double pressure : {1.0, 1e4, 1e6, 4e8}) {
          const StillRock rock{
              .aperture = 1e-2, .compliance = compliance, .reference_pressure = reference, .closed = closed};
          CAPTURE(int(closed), compliance, reference, pressure);
          const double content = rock.content_at(pressure, bulk_modulus);
          const double found = rock.pressure_of(content, bulk_modulus);
          CHECK(rock.content_at(found, bulk_modulus) == Approx(content).epsilon(rounding));
          // A content of doubles tells pressures no better than this apart.
          const double told = 4e-16 * content * bulk_modulus / rock.aperture;
          CHECK(found == Approx(pressure).epsilon(rounding).margin(2 * told));
        }
}

TEST_CASE("still rock: a node that is not filled has no pressure", "[coupler][conformance]") {
  const StillRock rock{.aperture = 1e-4, .compliance = 1e-10, .reference_pressure = 2e5};
  CHECK(rock.aperture_at(0) == Approx(0.8e-4).epsilon(1e-15));
  CHECK(rock.pressure_of(0.79e-4, bulk_modulus) == 0);
  CHECK(rock.pressure_of(0.81e-4, bulk_modulus) > 0);
}

TEST_CASE("still rock: an aperture is never below zero", "[coupler][conformance]") {
  const StillRock rock{.aperture = 1e-4, .compliance = 1e-10, .reference_pressure = 3e6};
  CHECK(rock.aperture_at(0) == 0);
  CHECK(rock.pressure_of(1e-5, bulk_modulus) > 2e6);
}

TEST_CASE("still rock: faces that touch yield to pressure above the reference only",
          "[coupler][conformance]") {
  const StillRock rock{.aperture = 1e-4, .compliance = 1e-10, .reference_pressure = 1e6, .closed = 1};
  CHECK(rock.aperture_at(0.9e6) == 1e-4);
  CHECK(rock.aperture_at(2e6) == Approx(2e-4).epsilon(1e-15));
}

TEST_CASE("still rock: a basin follows a tip and begins empty, even of a fracture that is full",
          "[coupler][conformance]") {
  FractureNetwork network;
  network.apply(natural_slit(5, 0.5, 2, 1e6, 1e-10));
  network.apply(basin(network, 4, 0.5, 3));
  const NetworkNode& end = network.nodes().back();
  CHECK_FALSE(end.saturated);
  CHECK(end.joint_compliance == 0);
  CHECK(end.lumped_length > 10 * network.nodes()[4].lumped_length);
  CHECK(end.exposure_time == 3);
  CHECK(end.x == Approx(network.nodes()[4].x + 0.5));
  CHECK(network.nodes()[4].lumped_length == 0.25);
  CHECK(network.segments().back().length == 0.5);
  CHECK(network.segments().back().kind == SegmentKind::hydraulic);
}
