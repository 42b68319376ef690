// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/moment_tensor.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/coupler/seismicity/sample_sources.hpp"

using namespace fissura;
using namespace fissura::coupler;
using namespace fissura::coupler::test;

namespace {

// Closed forms are evaluated with a few roundings.
constexpr double exact = 1e-12;

constexpr double degree = std::numbers::pi / 180;

/// Source of size mu A |d| = 1 whose slip points `slope` out of the plane; the plane is turned by `turn`.
PlaneTensor shear_tensile(double slope, double ratio_of_lame, double turn) {
  const std::array<double, 2> n{std::cos(turn), std::sin(turn)};
  const std::array<double, 2> d{std::sin(slope) * n[0] + std::cos(slope) * n[1],
                                std::sin(slope) * n[1] - std::cos(slope) * n[0]};
  return moment_of_jump(1, n, d, ratio_of_lame, 1);
}

PlaneTensor diagonal(double xx, double yy, double zz) {
  return {xx, yy, zz, 0};
}

void check_values(const PlaneTensor& moment, std::array<double, 3> expected) {
  const std::array<double, 3> found = principal_moments(moment).value;
  const double scale = std::max(std::abs(expected[0]), std::abs(expected[2]));
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(found[i] - expected[i]) <= exact * scale);
}

void check_shares(const PlaneTensor& moment, double iso, double clvd, double dc) {
  const Decomposition shares = decomposition(principal_moments(moment));
  CHECK(std::abs(shares.iso - iso) <= exact);
  CHECK(std::abs(shares.clvd - clvd) <= exact);
  CHECK(std::abs(shares.dc - dc) <= exact);
}

void check_hudson(const PlaneTensor& moment, double u, double v) {
  const HudsonPoint point = hudson_point(principal_moments(moment));
  CHECK(std::abs(point.u - u) <= exact);
  CHECK(std::abs(point.v - v) <= exact);
}

}  // namespace

TEST_CASE("slip is a pure double couple of moment mu A d", "[coupler][seismicity]") {
  const PlaneTensor moment = moment_of_jump(100, {0, 1}, {1e-3, 0}, lame_constant, shear_modulus);
  const double size = shear_modulus * 100 * 1e-3;
  CHECK(scalar_moment(moment) == Approx(4e9 / 3).epsilon(exact));
  CHECK(scalar_moment_bowers_hudson(moment) == Approx(4e9 / 3).epsilon(exact));
  CHECK(moment_magnitude(scalar_moment(moment)) == Approx(0.016626).margin(5e-7));
  check_values(moment, {size, 0, -size});
  check_shares(moment, 0, 0, 1);
  check_hudson(moment, 0, 0);
}

TEST_CASE("an opening crack in rock of nu = 0.2 is half isotropic, half CLVD", "[coupler][seismicity]") {
  const PlaneTensor moment = moment_of_jump(100, {0.6, 0.8}, {0.6e-3, 0.8e-3}, lame_constant, shear_modulus);
  const double size = shear_modulus * 100 * 1e-3;
  check_values(moment, {size * 8 / 3, size * 2 / 3, size * 2 / 3});
  check_shares(moment, 0.5, 0.5, 0);
  check_hudson(moment, -0.5, 0.5);
  CHECK(scalar_moment(moment) == Approx(2 * size).epsilon(exact));
  const HudsonTypes types = hudson_types(principal_moments(moment));
  CHECK(types.k == Approx(0.5).epsilon(exact));
  CHECK(types.T == Approx(-1).epsilon(exact));
}

TEST_CASE("a closing crack is an opening one with all signs reversed", "[coupler][seismicity]") {
  const PlaneTensor moment = moment_of_jump(100, {0, 1}, {0, -1e-3}, lame_constant, shear_modulus);
  check_shares(moment, -0.5, -0.5, 0);
  check_hudson(moment, 0.5, -0.5);
}

TEST_CASE("an opening crack in a Poisson solid lies on Hudson's mark", "[coupler][seismicity]") {
  const PlaneTensor moment = shear_tensile(std::numbers::pi / 2, 1, 0.3);
  check_values(moment, {3, 1, 1});
  check_shares(moment, 5.0 / 9, 4.0 / 9, 0);
  check_hudson(moment, -4.0 / 9, 5.0 / 9);
  CHECK(scalar_moment(moment) == Approx(std::sqrt(5.5)).epsilon(exact));
  CHECK(hudson_types(principal_moments(moment)).k == Approx(5.0 / 9).epsilon(exact));
}

TEST_CASE(
    "slip that opens by an angle has eigenvalues lambda s + mu (s + 1), lambda s, lambda s + mu (s - 1)",
    "[coupler][seismicity]") {
  for (const double slope : {10.0, 20.0, 30.0, 45.0, 80.0}) {
    const double s = std::sin(slope * degree);
    check_values(shear_tensile(slope * degree, 2.0 / 3, 0.7), {5 * s / 3 + 1, 2 * s / 3, 5 * s / 3 - 1});
    check_values(shear_tensile(slope * degree, 1, 2.9), {2 * s + 1, s, 2 * s - 1});
  }
}

TEST_CASE("shares of slip that opens by 10, 20, 30 and 45 degrees", "[coupler][seismicity]") {
  struct Row {
    double slope, iso, dc;
  };
  // The published digits are rounded.
  for (const Row& row : {Row{10, 17.9563, 64.0874}, Row{20, 29.0457, 41.9086}, Row{45, 43.2777, 13.4447}}) {
    const Decomposition shares =
        decomposition(principal_moments(shear_tensile(row.slope * degree, 2.0 / 3, 1.1)));
    CHECK(100 * shares.iso == Approx(row.iso).margin(5.1e-5));
    CHECK(100 * shares.clvd == Approx(row.iso).margin(5.1e-5));
    CHECK(100 * shares.dc == Approx(row.dc).margin(5.1e-5));
  }
  const PlaneTensor half = shear_tensile(30 * degree, 2.0 / 3, 0);
  check_values(half, {11.0 / 6, 1.0 / 3, -1.0 / 6});
  check_shares(half, 4.0 / 11, 4.0 / 11, 3.0 / 11);
  CHECK(scalar_moment(half) == Approx(std::sqrt(1.75)).epsilon(exact));
  check_shares(shear_tensile(30 * degree, 1, 0), 5.0 / 12, 1.0 / 3, 0.25);
}

TEST_CASE("slip that opens by more than asin(mu / (lambda + mu)) has no nodal line",
          "[coupler][seismicity]") {
  const double limit = std::asin(0.6);
  CHECK(principal_moments(shear_tensile(limit - 1e-6, 2.0 / 3, 0.2)).value[2] < 0);
  CHECK(principal_moments(shear_tensile(limit + 1e-6, 2.0 / 3, 0.2)).value[2] > 0);
}

TEST_CASE("slope and Lame ratio are found again from the tensor", "[coupler][seismicity]") {
  for (const double slope : {-60.0, -10.0, 10.0, 20.0, 30.0, 45.0, 89.0})
    for (const double ratio : {2.0 / 3, 1.0, 2.5}) {
      const PrincipalMoments moments = principal_moments(shear_tensile(slope * degree, ratio, 0.4));
      // Near a right angle the arcsine loses half of the digits.
      CHECK(std::sin(slope_angle(moments)) == Approx(std::sin(slope * degree)).epsilon(exact));
      CHECK(lame_ratio(decomposition(moments)) == Approx(ratio).epsilon(100 * exact));
    }
}

TEST_CASE("explosion, dipole and CLVD lie on their marks in Hudson's diamond", "[coupler][seismicity]") {
  check_shares(diagonal(2e6, 2e6, 2e6), 1, 0, 0);
  check_hudson(diagonal(2e6, 2e6, 2e6), 0, 1);
  check_shares(diagonal(0, 5, 0), 1.0 / 3, 2.0 / 3, 0);
  check_hudson(diagonal(0, 5, 0), -2.0 / 3, 1.0 / 3);
  check_hudson(diagonal(-1, 2, -1), -1, 0);
  check_hudson(diagonal(1, -2, 1), 1, 0);
  check_shares(diagonal(0, 0, 0), 0, 0, 0);
  check_hudson(diagonal(0, 0, 0), 0, 0);
}

TEST_CASE("turning a source in the plane changes none of its invariants", "[coupler][seismicity]") {
  const PlaneTensor straight = shear_tensile(0.2, 2.0 / 3, 0);
  const PrincipalMoments before = principal_moments(straight);
  for (int k = 1; k < 48; ++k) {
    const PlaneTensor turned = shear_tensile(0.2, 2.0 / 3, k * std::numbers::pi / 24);
    const PrincipalMoments after = principal_moments(turned);
    const Decomposition shares = decomposition(before);
    check_values(turned, before.value);
    check_shares(turned, shares.iso, shares.clvd, shares.dc);
    check_hudson(turned, hudson_point(before).u, hudson_point(before).v);
    CHECK(scalar_moment(turned) == Approx(scalar_moment(straight)).epsilon(exact));
    CHECK(hudson_types(after).k == Approx(hudson_types(before).k).epsilon(exact));
  }
}

TEST_CASE("a point that cracks at fixed strain loses stress across the crack only", "[coupler][seismicity]") {
  const PlaneTensor moment = diagonal(0, 1e6 * 10, 0);
  check_values(moment, {1e7, 0, 0});
  check_shares(moment, 1.0 / 3, 2.0 / 3, 0);
  CHECK(scalar_moment(moment) == Approx(1e7 / std::numbers::sqrt2).epsilon(exact));
  CHECK(moment_magnitude(scalar_moment(moment)) == Approx(-1.50034).margin(5e-6));
}

TEST_CASE("a fully opened crack band has the moment of its opening", "[coupler][seismicity]") {
  const double opening = 2 * 50 / 1e6;
  const PlaneTensor moment = moment_of_jump(10, {1, 0}, {opening, 0}, lame_constant, shear_modulus);
  check_values(moment, {32e9 / 0.9 * 1e-3, 8e9 / 0.9 * 1e-3, 8e9 / 0.9 * 1e-3});
  CHECK(scalar_moment(moment) == Approx(8e7 / 3).epsilon(exact));
  CHECK(moment_magnitude(scalar_moment(moment)) == Approx(-1.11602).margin(5e-6));
}

TEST_CASE("magnitudes of round moments", "[coupler][seismicity]") {
  for (const auto& [magnitude, moment] :
       {std::pair{-3.0, 3.981072e4}, {-2.0, 1.258925e6}, {-1.0, 3.981072e7}, {0.0, 1.258925e9}}) {
    CHECK(moment_of_magnitude(magnitude) == Approx(moment).epsilon(4e-7));
    CHECK(moment_magnitude(moment_of_magnitude(magnitude)) == Approx(magnitude).margin(exact));
  }
}

TEST_CASE("the norms of a moment differ unless it is a double couple", "[coupler][seismicity]") {
  const PlaneTensor opening = shear_tensile(std::numbers::pi / 2, 2.0 / 3, 0);
  CHECK(scalar_moment(opening) == Approx(2).epsilon(exact));
  CHECK(scalar_moment_bowers_hudson(opening) == Approx(8.0 / 3).epsilon(exact));
}

TEST_CASE("shares times basis tensors rebuild the eigenvalues", "[coupler][seismicity]") {
  for (int k = 0; k < 200; ++k) {
    const PlaneTensor moment{std::sin(1.0 * k), std::cos(2.3 * k), std::sin(0.7 * k + 1), std::cos(1.7 * k)};
    const PrincipalMoments principal = principal_moments(moment);
    const Decomposition shares = decomposition(principal);
    CHECK(std::abs(shares.iso) + std::abs(shares.clvd) + shares.dc == Approx(1).epsilon(exact));
    const auto [m1, m2, m3] = principal.value;
    const double whole = std::abs(m1 + m2 + m3) / 3 + std::abs(m1 + m3 - 2 * m2) * 2 / 3 +
                         0.5 * (m1 - m3 - std::abs(m1 + m3 - 2 * m2));
    const std::array<double, 3> couple{1, 0, -1};
    const std::array<double, 3> dipole =
        shares.clvd > 0 ? std::array{1.0, -0.5, -0.5} : std::array{0.5, 0.5, -1.0};
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(whole * (shares.iso + shares.dc * couple[i] + std::abs(shares.clvd) * dipole[i]) ==
            Approx(principal.value[i]).margin(exact));
  }
}

TEST_CASE("eigenvectors rebuild the tensor and are right-handed", "[coupler][seismicity]") {
  for (int k = 0; k < 200; ++k) {
    const PlaneTensor moment{std::sin(1.0 * k), std::cos(2.3 * k), 2 * std::sin(0.7 * k + 1),
                             std::cos(1.7 * k)};
    const auto [value, axis] = principal_moments(moment);
    CHECK(value[0] >= value[1]);
    CHECK(value[1] >= value[2]);
    const auto component = [&](std::size_t i, std::size_t j) {
      double sum = 0;
      for (std::size_t m = 0; m < 3; ++m) sum += value[m] * axis[m][i] * axis[m][j];
      return sum;
    };
    CHECK(component(0, 0) == Approx(moment[0]).margin(exact));
    CHECK(component(1, 1) == Approx(moment[1]).margin(exact));
    CHECK(component(2, 2) == Approx(moment[2]).margin(exact));
    CHECK(component(0, 1) == Approx(moment[3]).margin(exact));
    const auto& [a, b, c] = axis;
    CHECK(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
              a[2] * (b[0] * c[1] - b[1] * c[0]) ==
          Approx(1).epsilon(exact));
  }
}

TEST_CASE("the axis across the plane is the middle one of every shear-tensile source",
          "[coupler][seismicity]") {
  for (const double slope : {0.0, 0.5, 1.2, std::numbers::pi / 2})
    for (int k = 0; k < 12; ++k)
      CHECK(std::abs(principal_moments(shear_tensile(slope, 2.0 / 3, 0.5 * k)).axis[1][2]) == 1);
}
