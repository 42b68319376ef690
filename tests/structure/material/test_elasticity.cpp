// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/material/elasticity.hpp"
#include "structure/material/mohr_circle.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double rounding = 1e-13;  // a few operations on doubles

}  // namespace

TEST_CASE("plane strain: the shale of the paper under a given strain", "[structure][material]") {
  const auto moduli = elasticity(32e9, 0.2);
  const InPlane<double> strain{1e-4, -4e-5, 5e-5};
  const auto stress = elastic_stress(moduli, strain);
  CHECK(stress.xx == Approx(3.2e6).epsilon(rounding));
  CHECK(stress.yy == Approx(-1.6e6 / 3).epsilon(rounding));
  CHECK(stress.xy == Approx(2e6 / 3).epsilon(rounding));
  CHECK(out_of_plane_stress(moduli, strain) == Approx(1.6e6 / 3).epsilon(rounding));
}

TEST_CASE("plane strain: no out-of-plane strain comes with the stress", "[structure][material]") {
  const double youngs_modulus = 32e9, poissons_ratio = 0.2;
  const auto moduli = elasticity(youngs_modulus, poissons_ratio);
  const InPlane<double> strain{3e-4, 1e-4, 0};
  const auto stress = elastic_stress(moduli, strain);
  const double out_of_plane = out_of_plane_stress(moduli, strain);
  CHECK(out_of_plane == Approx(poissons_ratio * (stress.xx + stress.yy)).epsilon(rounding));
}

TEST_CASE("wave speeds of the shale", "[structure][material]") {
  const auto moduli = elasticity(32e9, 0.2);
  CHECK(compression_wave_speed(moduli, 2500) == Approx(3771.236).epsilon(1e-6));  // digits of the source
  CHECK(shear_wave_speed(moduli, 2500) == Approx(2309.401).epsilon(1e-6));
}

TEST_CASE("principal stresses rebuild the stress tensor", "[structure][material]") {
  const auto angle = GENERATE(0.0, 0.3, 1.2, 2.7);
  const double major = 2e6, minor = -5e6, c = std::cos(angle), s = std::sin(angle);
  const InPlane<double> stress{major * c * c + minor * s * s, major * s * s + minor * c * c,
                               (major - minor) * c * s};
  const auto found = principal(stress);
  CHECK(found.major == Approx(major).epsilon(rounding * 10));  // difference of larger numbers
  CHECK(found.minor == Approx(minor).epsilon(rounding * 10));
  CHECK(std::abs(found.direction[0] * c + found.direction[1] * s) == Approx(1).epsilon(rounding));
}

TEST_CASE("the tensile part keeps the tensile principal stresses only", "[structure][material]") {
  const double c = std::cos(0.4), s = std::sin(0.4);
  const auto rotated = [&](double major, double minor) {
    return InPlane<double>{major * c * c + minor * s * s, major * s * s + minor * c * c,
                           (major - minor) * c * s};
  };
  const auto check = [](const InPlane<double>& found, const InPlane<double>& expected) {
    const double margin = 1e-6;  // [Pa], rounding of megapascals
    CHECK(found.xx == Approx(expected.xx).margin(margin));
    CHECK(found.yy == Approx(expected.yy).margin(margin));
    CHECK(found.xy == Approx(expected.xy).margin(margin));
  };
  check(tensile_part(rotated(3e6, 1e6)), rotated(3e6, 1e6));
  check(tensile_part(rotated(3e6, -8e6)), rotated(3e6, 0));
  check(tensile_part(rotated(-1e6, -8e6)), {0, 0, 0});
}
