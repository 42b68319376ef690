// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "structure/fracture/crossing_criterion.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double degree = std::numbers::pi / 180, MPa = 1e6;

std::array<double, 2> unit(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Principal stresses (tension positive) of which `first` acts at `angle` from x.
InPlane<double> turned(double first, double second, double angle) {
  const double mean = (first + second) / 2, radius = (first - second) / 2;
  return {mean + radius * std::cos(2 * angle), mean - radius * std::cos(2 * angle),
          radius * std::sin(2 * angle)};
}

/// Growth along x, a natural fracture at `angle`, strength 1 MPa.
FractureMeeting meeting(double greatest, double least, double angle, double friction) {
  return {{1, 0}, unit(angle), {-greatest, -least, 0}, friction, 0, 1 * MPa};
}

double critical(CrossingRule rule, const FractureMeeting& m) {
  const CrossingVerdict verdict = crossing_verdict(rule, m);
  REQUIRE(verdict.critical_friction);
  return *verdict.critical_friction;
}

/// Gu & Weng by other means: Irwin's field in polar components, the scale by bisection, the friction by
/// trial.
double critical_by_trial(const FractureMeeting& m) {
  const double growth = std::atan2(m.hydraulic[1], m.hydraulic[0]);
  double critical = 0;
  for (const double side : {1.0, -1.0}) {
    const double arm = std::atan2(side * m.natural[1], side * m.natural[0]);
    const double theta = std::remainder(arm - growth, 2 * std::numbers::pi), c = std::cos(theta / 2);
    const auto stress_on_faces =
        [&](double k) {  // along, normal and shear in the frame of the natural fracture
          const double half = (m.stress.xx - m.stress.yy) / 2, mean = (m.stress.xx + m.stress.yy) / 2;
          const double turn = half * std::cos(2 * arm) + m.stress.xy * std::sin(2 * arm);
          return std::array{
              mean + turn + k * c * (1 + std::sin(theta / 2) * std::sin(theta / 2)),
              mean - turn + k * c * c * c,
              m.stress.xy * std::cos(2 * arm) - half * std::sin(2 * arm) + k * c * c * std::sin(theta / 2)};
        };
    double low = 0, high = 1e12;
    for (int i = 0; i < 200; ++i) {
      const double k = (low + high) / 2;
      const auto [along, normal, shear] = stress_on_faces(k);
      const double major = (along + normal) / 2 + std::hypot((along - normal) / 2, shear);
      (major < m.tensile_strength ? low : high) = k;
    }
    const auto [along, normal, shear] = stress_on_faces(low);
    critical = std::max(critical, (std::abs(shear) - m.cohesion) / -normal);
  }
  return critical;
}

}  // namespace

TEST_CASE("Renshaw and Pollard: the friction at which a fracture crosses at a right angle",
          "[structure][fracture][crossing]") {
  const auto rule = CrossingRule::renshaw_pollard;
  CHECK(critical(rule, meeting(15 * MPa, 10 * MPa, 90 * degree, 0)) == Approx(.319502).margin(5e-7));
  CHECK(critical(rule, meeting(15 * MPa, 5 * MPa, 90 * degree, 0)) == Approx(.152174).margin(5e-7));
  CHECK(critical(rule, meeting(20 * MPa, 5 * MPa, 90 * degree, 0)) == Approx(.109948).margin(5e-7));
}

TEST_CASE("Renshaw and Pollard: the stress ratio that holds the faces together falls with their friction",
          "[structure][fracture][crossing]") {
  const auto [friction, ratio] =
      GENERATE(std::pair{.2, 1.981132}, std::pair{.3, 1.430818}, std::pair{.6, .880503});
  const auto crosses = [&](double along) {
    return crossing_verdict(CrossingRule::renshaw_pollard,
                            meeting(along * 11 * MPa, 10 * MPa, 90 * degree, friction))
        .crosses;
  };
  CHECK(crosses(ratio + 1e-6));
  CHECK_FALSE(crosses(ratio - 1e-6));
}

TEST_CASE("Gu and Weng: the oblique fracture needs more friction", "[structure][fracture][crossing]") {
  const auto rule = CrossingRule::gu_weng;
  // Known to three digits.
  CHECK(critical(rule, meeting(15 * MPa, 10 * MPa, 90 * degree, 0)) == Approx(.289).margin(5e-4));
  CHECK(critical(rule, meeting(15 * MPa, 10 * MPa, 60 * degree, 0)) == Approx(.647).margin(5e-4));
  CHECK(critical(rule, meeting(12 * MPa, 10 * MPa, 90 * degree, 0)) == Approx(.378).margin(5e-4));
  CHECK_FALSE(crossing_verdict(rule, meeting(15 * MPa, 10 * MPa, 60 * degree, .6)).crosses);
  CHECK(crossing_verdict(rule, meeting(15 * MPa, 10 * MPa, 60 * degree, .7)).crosses);
}

TEST_CASE("Gu and Weng: as the polar field of the tip gives it, for stresses in any direction",
          "[structure][fracture][crossing]") {
  const double angle = GENERATE(35., 60., 90., 125.), off = GENERATE(-25., 0., 10.),
               heading = GENERATE(0., 77., -160.);
  FractureMeeting m;
  m.hydraulic = unit(heading * degree);
  m.natural = unit((heading + angle) * degree);
  m.stress = turned(-15 * MPa, -10 * MPa, (heading + off) * degree);
  m.tensile_strength = 1 * MPa;
  m.cohesion = GENERATE(0., .3e6);
  CHECK(critical(CrossingRule::gu_weng, m) == Approx(critical_by_trial(m)).epsilon(1e-9));
}

TEST_CASE("the verdict knows the side to which a natural fracture leans only from the stress",
          "[structure][fracture][crossing]") {
  const auto rule = CrossingRule::gu_weng;
  const auto leaning = [](double angle, double off) {
    FractureMeeting m = meeting(0, 0, angle * degree, 0);
    m.stress = turned(-15 * MPa, -10 * MPa, off * degree);
    return m;
  };
  const double aligned = critical(rule, leaning(60, 0));
  CHECK(critical(rule, leaning(120, 0)) == Approx(aligned).epsilon(1e-12));
  CHECK(critical(rule, leaning(-60, 0)) == Approx(aligned).epsilon(1e-12));
  const double turned_towards = critical(rule, leaning(60, 10));
  CHECK(critical(rule, leaning(-120, 10)) == Approx(turned_towards).epsilon(1e-12));
  CHECK(critical(rule, leaning(-60, -10)) == Approx(turned_towards).epsilon(1e-12));
  // The greatest compression turned towards the natural fracture presses its faces together less.
  CHECK(turned_towards > aligned + .05);
  CHECK(critical(rule, leaning(60, -10)) < aligned - .05);
}

TEST_CASE("cemented faces cross without friction once the cement carries the shear",
          "[structure][fracture][crossing]") {
  FractureMeeting m = meeting(15 * MPa, 10 * MPa, 60 * degree, 0);
  const double loose = critical(CrossingRule::gu_weng, m);
  m.cohesion = 1 * MPa;
  CHECK(critical(CrossingRule::gu_weng, m) < loose);
  CHECK_FALSE(crossing_verdict(CrossingRule::gu_weng, m).crosses);
  m.cohesion = 15 * MPa;  // no shear stress on any plane is greater
  CHECK(critical(CrossingRule::gu_weng, m) == 0);
  CHECK(crossing_verdict(CrossingRule::gu_weng, m).crosses);
}

TEST_CASE("faces pulled apart are not held together by friction", "[structure][fracture][crossing]") {
  FractureMeeting m = meeting(-0.1 * MPa, 10 * MPa, 90 * degree, 5);
  CHECK_FALSE(crossing_verdict(CrossingRule::renshaw_pollard, m).critical_friction);
  m.stress = {0.5 * MPa, 0.5 * MPa, 0};
  CHECK_FALSE(crossing_verdict(CrossingRule::gu_weng, m).critical_friction);
}

TEST_CASE("Blanton: the stress difference at which a fracture crosses falls with the angle",
          "[structure][fracture][crossing]") {
  const auto [angle, ratio] = GENERATE(std::pair{45., 5.0}, std::pair{50., 2.69826}, std::pair{60., 1.48543},
                                       std::pair{70., 1.11782}, std::pair{75., 1.03517}, std::pair{90., 1.0});
  const auto crosses = [&](double difference) {
    return crossing_verdict(CrossingRule::blanton,
                            meeting((10 + difference) * MPa, 10 * MPa, angle * degree, 0))
        .crosses;
  };
  CHECK(crosses(ratio * (1 + 1e-5)));
  CHECK_FALSE(crosses(ratio * (1 - 1e-5)));
  CHECK_FALSE(crossing_verdict(CrossingRule::blanton, meeting(1000 * MPa, 10 * MPa, 30 * degree, 1)).crosses);
}

TEST_CASE("the angle of a meeting is the acute one, and a rule may leave no choice",
          "[structure][fracture][crossing]") {
  const double angle = GENERATE(20., 160., -20., 200.);
  const CrossingVerdict never =
      crossing_verdict(CrossingRule::never, meeting(15 * MPa, 10 * MPa, angle * degree, 9));
  CHECK(never.angle == Approx(20 * degree));
  CHECK_FALSE(never.crosses);
  CHECK_FALSE(never.critical_friction);
  CHECK(crossing_verdict(CrossingRule::always, meeting(15 * MPa, 10 * MPa, angle * degree, 0)).crosses);
  CHECK_FALSE(crossing_verdict(CrossingRule::gu_weng, meeting(15 * MPa, 10 * MPa, 0, 9)).crosses);
}
