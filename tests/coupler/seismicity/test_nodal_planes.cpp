// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/coupler/seismicity/sample_sources.hpp"

using namespace fissura;
using namespace fissura::coupler;
using namespace fissura::coupler::test;

namespace {

using Vector = std::array<double, 3>;

constexpr double degree = std::numbers::pi / 180;
constexpr double exact = 1e-12;

void check_plane(const NodalPlane& plane, double strike, double dip, double rake) {
  CHECK(plane.strike / degree == Approx(strike).margin(1e-9));
  CHECK(plane.dip / degree == Approx(dip).margin(1e-9));
  CHECK(plane.rake / degree == Approx(rake).margin(1e-9));
}

Geography geography_of(const Georeference& georeference) {
  Case value;
  value.rock.density = 2400;
  value.rock.youngs_modulus = 32e9;
  value.rock.poissons_ratio = 0.2;
  value.georeference = georeference;
  return extraction_controls(value).geography;
}

/// The record of a slip of 1 mm along a vertical plane in plan view; +1: its +normal side, to the right of
/// the strike, moves along the strike.
SourceRecord slip_along(double strike, double sense) {
  SourceRecord record = slip_record(1, 0, {0, 0});
  record.normal = {std::cos(strike), -std::sin(strike)};
  record.jump = {sense * 1e-3 * std::sin(strike), sense * 1e-3 * std::cos(strike)};
  record.moment = moment_of_jump(record.extent, record.normal, record.jump, lame_constant, shear_modulus);
  return record;
}

}  // namespace

TEST_CASE("faults of textbook kinds have their strike, dip and rake", "[coupler][seismicity]") {
  const Geography level;
  const double c = std::cos(60 * degree), s = std::sin(60 * degree);
  const Vector dipping_east{s, 0, c}, up_dip{-c, 0, s}, down_dip{c, 0, -s};
  check_plane(nodal_plane(dipping_east, up_dip, level), 0, 60, 90);
  check_plane(nodal_plane(dipping_east, down_dip, level), 0, 60, -90);
  check_plane(nodal_plane(dipping_east, {0, 1, 0}, level), 0, 60, 0);
  check_plane(nodal_plane(dipping_east, {0, -1, 0}, level), 0, 60, 180);
  // Described from the other side.
  check_plane(nodal_plane({-s, 0, -c}, down_dip, level), 0, 60, 90);
  check_plane(nodal_plane({0, -s, c}, {0, c, s}, level), 90, 60, 90);
  check_plane(nodal_plane({-s, 0, c}, {c, 0, s}, level), 180, 60, 90);
  check_plane(nodal_plane({0, 0, 1}, {1, 0, 0}, level), 0, 0, -90);
  // Opening has no rake.
  check_plane(nodal_plane(dipping_east, dipping_east, level), 0, 60, 0);
}

TEST_CASE("slip along vertical planes: strike, both senses, true plane first", "[coupler][seismicity]") {
  for (const double strike : {0.0, 30.0, 330.0, 90.0})
    for (const double sense : {1.0, -1.0}) {
      const SourceRecord record = slip_along(strike * degree, sense);
      const SeismicEvent event = events_of(shale_controls(), {record}).at(0);
      check_plane(event.plane, strike, 90, sense > 0 ? 0 : 180);
      // Of the two strikes across it the one from 315 to 135 degrees.
      const double across = strike == 0 ? 90 : strike == 30 ? 120 : strike == 330 ? 60 : 0;
      check_plane(event.auxiliary_plane, across, 90, sense > 0 ? 180 : 0);
      // The sign of the normal is a matter of naming.
      SourceRecord renamed = record;
      for (double& component : renamed.normal) component = -component;
      for (double& component : renamed.jump) component = -component;
      CHECK(bytes_of(events_of(shale_controls(), {renamed})) == bytes_of({event}));
    }
}

TEST_CASE("left-lateral slip on a plane that strikes 330: components in case axes and up, south, east",
          "[coupler][seismicity]") {
  const double size = shear_modulus * 10 * 1e-3;
  const SeismicEvent event = events_of(shale_controls(), {slip_along(330 * degree, 1)}).at(0);
  const double s = std::sqrt(0.75);
  const PlaneTensor expected{-s * size, s * size, 0, 0.5 * size};
  const std::array<double, 6> geographic{0, s * size, -s * size, 0, 0, -0.5 * size};
  const std::array<double, 6> found = up_south_east(event.moment, {});
  for (std::size_t i = 0; i < 4; ++i) CHECK(event.moment[i] == Approx(expected[i]).margin(exact * size));
  for (std::size_t i = 0; i < 6; ++i) CHECK(found[i] == Approx(geographic[i]).margin(exact * size));
}

TEST_CASE("planes of a tensor rebuild it", "[coupler][seismicity]") {
  for (int k = 0; k < 24; ++k) {
    const double angle = k * 15 * degree;
    const PlaneTensor moment{std::sin(angle), -std::sin(angle), 0, std::cos(angle)};
    for (const NodalPlane& plane : nodal_planes(principal_moments(moment), {1, 0, 0}, {})) {
      // Aki & Richards (2002), Eq. 4.91, for a vertical plane.
      const double nn = -std::sin(plane.dip) * std::cos(plane.rake) * std::sin(2 * plane.strike);
      const double ne = std::sin(plane.dip) * std::cos(plane.rake) * std::cos(2 * plane.strike);
      CHECK(moment[1] == Approx(nn).margin(1e-9));
      CHECK(moment[3] == Approx(ne).margin(1e-9));
    }
  }
}

TEST_CASE("rounding turns no strike along an axis", "[coupler][seismicity]") {
  for (const double strike : {0.0, 90.0})
    for (const double turn : {-0.01, 0.01}) {
      const SeismicEvent event = events_of(shale_controls(), {slip_along((strike + turn) * degree, 1)}).at(0);
      CHECK(std::remainder(event.plane.strike / degree - strike, 360) == Approx(turn).margin(1e-9));
    }
  const double half = std::sqrt(0.5);
  for (const double sign : {1.0, -1.0}) {
    check_plane(nodal_plane({sign * half, sign * half, 0}, {sign * half, -sign * half, 0}, {}), 135, 90, 180);
    check_plane(nodal_plane({sign * half, sign * (half + 1e-12), 0}, {0, 0, sign}, {}), 135, 90, -90);
  }
}

TEST_CASE("the plane nearest to the true normal comes first", "[coupler][seismicity]") {
  const PrincipalMoments moments = principal_moments({0, 0, 0, 1});
  check_plane(nodal_planes(moments, {0.1, 0.995, 0}, {})[0], 90, 90, 180);
  check_plane(nodal_planes(moments, {0.995, -0.1, 0}, {})[0], 0, 90, 0);
}

TEST_CASE("an opening fracture strikes along its trace and has no rake", "[coupler][seismicity]") {
  SourceRecord record = slip_along(30 * degree, 1);
  record.kind = SourceKind::new_crack;
  record.jump = {1e-3 * record.normal[0], 1e-3 * record.normal[1]};
  record.moment = moment_of_jump(record.extent, record.normal, record.jump, lame_constant, shear_modulus);
  const SeismicEvent event = events_of(shale_controls(), {record}).at(0);
  CHECK(event.type == EventType::tensile);
  check_plane(event.plane, 30, 90, 0);
}

TEST_CASE("the azimuth of the y axis turns every strike of a plan view", "[coupler][seismicity]") {
  Georeference georeference;
  georeference.azimuth = 25 * degree;
  ExtractionControls controls = shale_controls();
  controls.geography = geography_of(georeference);
  check_plane(events_of(controls, {slip_along(30 * degree, 1)}).at(0).plane, 55, 90, 0);
  check_plane(events_of(controls, {slip_along(330 * degree, -1)}).at(0).plane, 355, 90, 180);
  // A plane along y moves along azimuth 25: M_ne = cos(50), as Aki & Richards have it.
  const PlaneTensor moment = slip_along(0, 1).moment;
  const double size = scalar_moment(moment);
  const std::array<double, 6> found = up_south_east(moment, controls.geography);
  CHECK(found[1] == Approx(-size * std::sin(50 * degree)).epsilon(exact));
  CHECK(found[5] == Approx(-size * std::cos(50 * degree)).epsilon(exact));
  const AxisDirection y = axis_direction({0, 1, 0}, controls.geography);
  CHECK(y.azimuth == Approx(25 * degree).epsilon(exact));
  CHECK(y.plunge == 0);
}

TEST_CASE("in a section x points along its azimuth and y up", "[coupler][seismicity]") {
  Georeference georeference;
  georeference.section_azimuth = 70 * degree;
  const Geography geography = geography_of(georeference);
  CHECK(axis_direction({1, 0, 0}, geography).azimuth == Approx(70 * degree).epsilon(exact));
  CHECK(axis_direction({0, -1, 0}, geography).plunge == Approx(90 * degree).epsilon(exact));
  CHECK(axis_direction({0, 1, 0}, geography).plunge == Approx(90 * degree).epsilon(exact));
  // x, y, z stay right-handed.
  CHECK(axis_direction({0, 0, 1}, geography).azimuth == Approx(160 * degree).epsilon(exact));

  // A fault that dips 60 degrees along x; the rock above moves up: a thrust that strikes 90 to the left.
  const double c = std::cos(60 * degree), s = std::sin(60 * degree);
  SourceRecord record = slip_record(1, 0, {0, 0});
  record.normal = {s, c};
  record.jump = {-1e-3 * c, 1e-3 * s};
  record.moment = moment_of_jump(record.extent, record.normal, record.jump, lame_constant, shear_modulus);
  ExtractionControls controls = shale_controls();
  controls.geography = geography;
  const SeismicEvent event = events_of(controls, {record}).at(0);
  check_plane(event.plane, 340, 60, 90);
  check_plane(event.auxiliary_plane, 160, 30, 90);
  const std::array<double, 6> found = up_south_east(event.moment, geography);
  CHECK(found[0] == Approx(event.scalar_moment * std::sin(120 * degree)).epsilon(exact));
  CHECK(found[1] + found[2] == Approx(-found[0]).epsilon(exact));
}

TEST_CASE("without a georeference y points north in plan view", "[coupler][seismicity]") {
  const Geography geography = shale_controls().geography;
  CHECK(geography.north == Vector{0, 1, 0});
  CHECK(geography.up == Vector{0, 0, 1});
  const AxisDirection axis = axis_direction({std::sin(0.4), std::cos(0.4), 0}, geography);
  CHECK(axis.azimuth == Approx(0.4).epsilon(exact));
}

TEST_CASE("controls of a case: Lame's constants and shear waves of its rock", "[coupler][seismicity]") {
  Case value;
  value.domain.thickness = 10;
  value.rock.density = 2400;
  value.rock.youngs_modulus = 32e9;
  value.rock.poissons_ratio = 0.2;
  const ExtractionControls controls = extraction_controls(value);
  CHECK(controls.lame == Approx(8.888888888888889e9).epsilon(exact));
  CHECK(controls.shear == Approx(1.333333333333333e10).epsilon(exact));
  CHECK(controls.shear_wave_speed == Approx(2357.0226).epsilon(1e-7));
  CHECK(controls.thickness == 10);
}
