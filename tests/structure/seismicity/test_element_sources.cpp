// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/central_difference.hpp"
#include "structure/seismicity/source_observer.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"
#include "tests/structure/seismicity/principal_values.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double thickness = 10;         // [m]
constexpr double area = 1, volume = 10;  // of each element [m2], [m3]
constexpr double exact = 1e-12;          // rounding
constexpr double instant = 1e-12;        // a step in which nothing moves [s]
const Grid two_elements{1, 2, 1, 1};

Case brittle(const std::array<double, 4>& in_situ) {
  Case settings = shale_case();
  settings.domain = {1, 2, thickness};
  settings.in_situ.stress = in_situ;
  settings.bulk_failure.active = true;
  settings.bulk_failure.softening = Softening::linear;
  return settings;
}

/// Two elements whose strain a test sets; the element loop gives their damage and stress.
class Element {
 public:
  explicit Element(const Case& settings) : settings_(settings) {}

  /// An interval of one step at the in-plane strain xx, yy, gamma_xy.
  std::vector<SourceRecord> strain(const InPlane<double>& strain) {
    observer_.begin_interval(rock(), time_, joints_);
    for (std::size_t node = 0; node < mesh_.position.size(); ++node) {
      const auto [x, y] = mesh_.position[node];
      state_.displacement[2 * node] = strain.xx * x + strain.xy * y;
      state_.displacement[2 * node + 1] = strain.yy * y;
    }
    state_.velocity.assign(state_.velocity.size(), 0);
    dynamics_.advance(state_, {instant, time_ + instant, 1, 0});
    observer_.watch(rock(), 1, instant);
    observer_.end_interval(rock(), {time_, time_ + 1, 1, 1}, joints_);
    time_ += 1;
    return observer_.take(1);
  }

  std::vector<SourceRecord> tell_quiet() {
    observer_.tell_quiet(rock(), joints_);
    return observer_.take(1);
  }

  [[nodiscard]] const Elasticity& moduli() const { return moduli_; }

 private:
  [[nodiscard]] ObservedRock rock() const {
    return {mesh_, body_, tiles_, moduli_, settings_, 0, state_.displacement, state_.damage};
  }

  Case settings_;
  Elasticity moduli_ = elasticity(settings_.rock);
  Mesh mesh_ = jittered_mesh(two_elements);
  Body body_ = build_body(mesh_, settings_);
  Tiles tiles_ = build_tiles(mesh_, body_, {});
  State state_ = state_at_rest(body_, tiles_);
  CentralDifference dynamics_{body_, tiles_, moduli_, rock_failure(settings_.rock, settings_.bulk_failure),
                              1};
  Joints joints_;
  SourceObserver observer_{Seismicity{}};
  double time_ = 0;
};

constexpr double strength = 1e6, band = 1;  // [Pa], [m]: across x

}  // namespace

TEST_CASE("rock that is loaded elastically is no source", "[structure][seismicity]") {
  Element element(brittle({0, -5e6, 0, -3e6}));
  for (const double share : {0.5, 0.9, -3.0, 0.99}) {
    const double strain = share * strength / (element.moduli().lame + 2 * element.moduli().shear);
    CHECK(element.strain({strain, 1e-6, 0}).empty());
  }
  CHECK(element.tell_quiet().empty());
}

TEST_CASE("rock that loses 1 MPa across a crack at a fixed strain has a single eigenvalue, volume times loss",
          "[structure][seismicity]") {
  Element element(brittle({0, -20e6, 0, -20e6}));
  const double modulus = element.moduli().lame + 2 * element.moduli().shear;
  const double onset = strength / modulus, end = 2 * shale_case().rock.fracture_energy / (strength * band);
  // M kappa - f_t (end - kappa) / (end - onset) = loss
  const double loss = 1e6;
  const double kappa = (loss + strength * end / (end - onset)) / (modulus + strength / (end - onset));
  const auto records = element.strain({kappa, 0, 0});
  REQUIRE(records.size() == 2);
  for (const SourceRecord& record : records) {
    CHECK(record.kind == SourceKind::bulk_tension);
    CHECK(record.failing);
    CHECK(record.extent == Approx(volume));
    const auto values = principal_values(record.moment);
    CHECK(values[0] == Approx(volume * loss).epsilon(exact));
    CHECK(values[1] == Approx(0).margin(1e-8 * volume * loss));  // compression far above it cancels
    CHECK(values[2] == Approx(0).margin(1e-8 * volume * loss));
    CHECK(std::sqrt((values[0] * values[0]) / 2) == Approx(7.0711e6).epsilon(1e-5));
    CHECK(record.pseudo_moment[0] == Approx(volume * loss).epsilon(exact));
    CHECK(record.normal_before - record.normal_after == Approx(loss).epsilon(exact));
    CHECK(std::abs(record.normal[0]) == Approx(1));
    CHECK(record.measure > 0);
    CHECK(record.measure < 1);
  }
}

TEST_CASE("rock that a crack has parted has the moment of that crack as a displacement jump",
          "[structure][seismicity]") {
  Element element(brittle({0, 0, 0, 0}));
  const double width = 2 * shale_case().rock.fracture_energy / strength;
  PlaneTensor sum{};
  int told = 0;
  for (const double share : {0.3, 0.5, 0.8, 1.0})
    for (const SourceRecord& record : element.strain({share * width / band, 0, 0}))
      if (record.entity == 0) {
        ++told;
        sum = sum + record.moment;
      }
  CHECK(told == 4);
  const double crack = volume / band;  // its area [m2]
  CHECK(crack == 10);
  const PlaneTensor expected = moment_of_jump(element.moduli(), {1, 0}, {width, 0}, crack);
  for (int k = 0; k < 4; ++k) CHECK(sum[k] == Approx(expected[k]).epsilon(exact).margin(exact * 1e7));
  const auto values = principal_values(sum);
  CHECK(values[0] == Approx(3.5556e7).epsilon(2e-5));
  CHECK(values[1] == Approx(8.889e6).epsilon(2e-5));
  CHECK(values[2] == Approx(8.889e6).epsilon(2e-5));
}

TEST_CASE("a crack that closes along its secant is quiet: told when asked, and not as failing",
          "[structure][seismicity]") {
  Element element(brittle({0, 0, 0, 0}));
  const double strain = 5e-5;
  REQUIRE(element.strain({strain, 0, 0}).size() == 2);
  CHECK(element.strain({strain / 2, 0, 0}).empty());
  CHECK(element.strain({strain / 4, 0, 0}).empty());
  const auto quiet = element.tell_quiet();
  REQUIRE(quiet.size() == 2);
  CHECK_FALSE(quiet[0].failing);
  CHECK(quiet[0].moment[0] < 0);
  CHECK(quiet[0].begin == 0);
  CHECK(quiet[0].end == 3);
  CHECK(element.tell_quiet().empty());
  CHECK(element.strain({strain, 0, 0}).empty());  // back to where it was
  PlaneTensor round_trip = quiet[0].moment + element.tell_quiet()[0].moment;
  for (const double component : round_trip) CHECK(component == Approx(0).margin(exact * 1e7));
}

TEST_CASE("rock that flows without dilation has a deviatoric moment 2 mu V eps_p",
          "[structure][seismicity]") {
  Case settings = brittle({0, 0, 0, 0});
  settings.bulk_failure.cohesion = 5e6;
  settings.bulk_failure.friction_angle = 0.5;
  Element element(settings);
  const auto records = element.strain({0, -3e-3, 0});
  REQUIRE(records.size() == 2);
  CHECK(records[0].kind == SourceKind::bulk_shear);
  const PlaneTensor& moment = records[0].moment;
  const double size = size_of(moment);
  CHECK(size > 1e6);
  CHECK(moment[0] + moment[1] + moment[2] == Approx(0).margin(1e-9 * size));
  CHECK(moment[0] > 0);
  CHECK(moment[1] < 0);
}
