// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/joints/joint_step.hpp"
#include "structure/seismicity/source_observer.hpp"
#include "tests/fakes/structure/shale_case.hpp"
#include "tests/structure/seismicity/principal_values.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double degree = 0.017453292519943295;
constexpr double length = 10, thickness = 10;  // [m]
constexpr double area = length * thickness;
constexpr double displacement = 1e-3;  // [m]
constexpr int steps = 100;
constexpr double step = 1e-4;    // [s]
constexpr double exact = 1e-12;  // rounding of a hundred sums

/// Two point masses that move apart or along each other with a given velocity, observed as the structure is.
class Patch {
 public:
  Patch(double poissons_ratio, double turned, const JointProperties& properties) {
    settings_.rock.poissons_ratio = poissons_ratio;
    settings_.domain.thickness = thickness;
    moduli_ = elasticity(settings_.rock);
    normal_ = {-std::sin(turned), std::cos(turned)};
    mesh_.position = {{0, 0}, {0, 0}};
    mesh_.units = {{0, 1, {length * normal_[0], length * normal_[1]}, length, 0, 0}};
    mesh_.vertices = {{{3, 4}, {0}, 0, {}}};
    joints_.properties = {properties};
    joints_.state.resize(1);
    joints_.released = {1};
    joints_.ramp.resize(1);
    joint_step_.emplace(mesh_, nodes_, 1);
  }

  /// Moves plus against minus at an angle to the plane, by `displacement` in all [m], and tells everything.
  std::vector<SourceRecord> move(double slope, double press) {
    const double along = displacement / (steps * step) * std::cos(slope),
                 across = displacement / (steps * step) * std::sin(slope);
    const auto [nx, ny] = normal_;
    velocity_ = {0, 0, along * ny + across * nx, -along * nx + across * ny};
    observer_.begin_interval(rock(), 0, joints_);
    const std::vector<double> force{press * nx, press * ny, -press * nx, -press * ny};
    for (int k = 1; k <= steps; ++k)
      joint_step_->advance({force, nodes_, mass_, displacement_, velocity_},
                           {step, 1, 0, static_cast<double>(k) / steps}, joints_);
    observer_.end_interval(rock(), {0, steps * step, steps, 4}, joints_);
    observer_.tell_quiet(rock(), joints_);
    return observer_.take(7);
  }

  [[nodiscard]] std::array<double, 2> normal() const { return normal_; }
  [[nodiscard]] const Elasticity& moduli() const { return moduli_; }

 private:
  [[nodiscard]] ObservedRock rock() const {
    return {mesh_, body_, tiles_, moduli_, settings_, 3, displacement_, damage_};
  }

  Case settings_ = shale_case();
  Elasticity moduli_;
  std::array<double, 2> normal_{};
  Mesh mesh_;
  Body body_;
  Tiles tiles_;
  Damage damage_;
  Joints joints_;
  std::vector<NodeIndex> nodes_{0, 1};
  std::vector<double> mass_{1e6, 1e6}, displacement_ = std::vector<double>(4, 0), velocity_;
  std::optional<JointStep> joint_step_;
  SourceObserver observer_{Seismicity{}};
};

constexpr double shale = 0.2, poisson_solid = 0.25;
constexpr double pressed = 1e7, apart = -1e-6, torn = -20;  // on plus towards minus [N/m]

void check_principal_values(const PlaneTensor& moment, const std::array<double, 3>& expected) {
  const auto values = principal_values(moment);
  for (int k = 0; k < 3; ++k) CHECK(values[k] == Approx(expected[k]).epsilon(exact).margin(exact * 1e9));
}

}  // namespace

TEST_CASE("a patch of faces that slides by d has the moment mu A d of a double couple, in any direction",
          "[structure][seismicity]") {
  Patch patch(shale, GENERATE(0.0, 30.0, 77.0, 150.0) * degree, {});
  const auto records = patch.move(0, pressed);
  REQUIRE(records.size() == 1);
  const SourceRecord& record = records.front();
  CHECK(record.kind == SourceKind::contact_slip);
  CHECK(record.failing);
  const double moment = patch.moduli().shear * area * displacement;
  CHECK(moment == Approx(1.333333e9).epsilon(1e-6));
  check_principal_values(record.moment, {moment, 0, -moment});
  CHECK(record.moment[2] == Approx(0).margin(exact * moment));
  CHECK(record.begin == 0);
  CHECK(record.end == steps * step);
  CHECK(record.centroid_time == Approx(steps * step * (1 + 1.0 / steps) / 2));  // ends of steps
  CHECK(record.measure == Approx(displacement));
  CHECK(record.peak_rate == Approx(displacement / (steps * step)));
  CHECK(record.interval == 7);
  CHECK(record.geometry == 3);
  CHECK(record.mass_scale == 4);
  CHECK(record.position == std::array<double, 2>{3, 4});
  CHECK(record.extent == area);
  CHECK(record.normal_after == Approx(-pressed / length));
}

TEST_CASE("a patch that opens or closes has the moment A d (lambda + 2 mu, lambda, lambda)",
          "[structure][seismicity]") {
  const double ratio = GENERATE(shale, poisson_solid);
  Patch patch(ratio, 20 * degree, {});
  const double sign = GENERATE(1.0, -1.0);
  if (sign < 0) patch.move(90 * degree, apart);  // what closes was open
  const auto records = patch.move(sign * 90 * degree, apart);
  REQUIRE(records.size() == 1);
  CHECK(records[0].kind == SourceKind::contact_opening);
  CHECK_FALSE(records[0].failing);
  const auto [lame, shear] = patch.moduli();
  const double unit = sign * area * displacement;
  CHECK((lame + 2 * shear) / shear == Approx(ratio == shale ? 8.0 / 3 : 3));
  const auto [nx, ny] = patch.normal();
  const PlaneTensor expected{unit * (lame + 2 * shear * nx * nx), unit * (lame + 2 * shear * ny * ny),
                             unit * lame, unit * 2 * shear * nx * ny};
  for (int k = 0; k < 4; ++k)
    CHECK(records[0].moment[k] == Approx(expected[k]).epsilon(exact).margin(exact * 1e9));
}

TEST_CASE(
    "a patch that opens at a slope has the eigenvalues lambda s + mu (s + 1), lambda s, lambda s + mu (s - "
    "1)",
    "[structure][seismicity]") {
  const double slope = GENERATE(10.0, 20.0, 30.0, 45.0), turned = GENERATE(0.0, 63.0);
  const double ratio = GENERATE(shale, poisson_solid);
  Patch patch(ratio, turned * degree, {});
  const auto records = patch.move(slope * degree, apart);
  REQUIRE(records.size() == 1);
  const double unit = patch.moduli().shear * area * displacement;
  const double lame = patch.moduli().lame / patch.moduli().shear, s = std::sin(slope * degree);
  check_principal_values(records[0].moment,
                         {unit * (lame * s + s + 1), unit * lame * s, unit * (lame * s + s - 1)});
  if (ratio == shale && slope == 10.0) {
    const auto values = principal_values(records[0].moment);
    CHECK(values[0] / unit == Approx(1.289414).margin(1e-6));
    CHECK(values[1] / unit == Approx(0.115765).margin(1e-6));
    CHECK(values[2] / unit == Approx(-0.710586).margin(1e-6));
  }
}

TEST_CASE("faces that part while their cohesion wears off are a new crack; what they open beyond is none",
          "[structure][seismicity]") {
  JointProperties weak;
  weak.cohesive = {1, 0.25e-3};  // breaks half-way
  Patch patch(shale, 0, weak);
  const auto records = patch.move(90 * degree, torn);
  REQUIRE(records.size() == 2);
  CHECK(records[0].kind == SourceKind::new_crack);
  CHECK(records[0].failing);
  CHECK(records[0].jump[1] == Approx(displacement / 2).epsilon(1.5 / steps));
  CHECK(records[0].end == Approx(steps * step / 2).epsilon(3.0 / steps));
  CHECK(records[1].kind == SourceKind::contact_opening);
  CHECK(records[0].jump[1] + records[1].jump[1] == Approx(displacement).epsilon(1e-4));  // cohesion brakes
}

TEST_CASE("faces that friction holds tell of nothing, whatever loads them", "[structure][seismicity]") {
  JointProperties rough;
  rough.friction_coefficient = 1e6;
  Patch patch(shale, 40 * degree, rough);
  CHECK(patch.move(0, pressed).empty());
}
