// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "tests/fakes/structure/jittered_mesh.hpp"
#include "tests/fakes/structure/shale_case.hpp"

/// A column struck at its western end with a constant velocity: the front runs at the wave speed c and leaves
/// the stress density c v behind it (Kolsky, Stress Waves in Solids, ch. 2).

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double length = 14, station = 10, struck_velocity = 1;
constexpr double tolerance = 0.01;

struct Front {
  double arrival = 0;        ///< at the station, when half the velocity is reached [s]
  InPlane<double> stress{};  ///< mean behind the front, when it arrives [Pa]
};

// `kind` of the long sides: rollers make a column in uniaxial strain (axis 0) or, if every x displacement is
// held, in simple shear (axis 1).
Front run_column(Case settings, int axis, double mass_scale) {
  const Mesh mesh = jittered_mesh({length, 0.4, 140, 4, 0.15, 6});
  std::array<double, 2> travel{};
  travel[axis] = struck_velocity;
  settings.boundary.west = {BoundaryKind::displacement, travel, 1};
  Body body = build_body(mesh, settings);
  if (axis == 1)
    for (auto& inverse_mass : body.inverse_mass) inverse_mass[0] = 0;
  const auto tiles = build_tiles(mesh, body, {});
  const auto moduli = elasticity(settings.rock);
  const auto stiffest = stiffest_element(mesh, moduli, settings.rock.density);
  const double size = stable_step(stiffest.frequency_squared, 0, {0.5, mass_scale, 0});
  State state = state_at_rest(body);
  CentralDifference dynamics(body, tiles, moduli, 1);

  const auto station_x = station - 0.5 * length;
  const auto mean_velocity = [&] {
    double sum = 0, count = 0;
    for (std::size_t node = 0; node < mesh.position.size(); ++node)
      if (std::abs(mesh.position[node][0] - station_x) < 0.1) {
        sum += state.velocity[2 * node + axis];
        ++count;
      }
    return sum / count;
  };
  double before = 0;
  for (int i = 1;; ++i) {
    REQUIRE(i < 20000);
    dynamics.advance(state, {size, i * size, mass_scale, 0});
    const double now = mean_velocity();
    if (now >= 0.5 * struck_velocity) {
      Front front;
      front.arrival = size * (i - 0.5 - (now - 0.5 * struck_velocity) / (now - before));
      double area = 0;
      const auto stress = effective_stress(mesh, body, moduli, state.displacement, {});
      for (ElementIndex element = 0; element < stress.size(); ++element) {
        const double x = centroid(mesh, element)[0] + 0.5 * length, a = triangle(mesh, element).area;
        if (x < 2 || x > 8) continue;
        area += a;
        front.stress.xx += a * stress[element].in_plane.xx;
        front.stress.yy += a * stress[element].in_plane.yy;
        front.stress.xy += a * stress[element].in_plane.xy;
      }
      front.stress = {front.stress.xx / area, front.stress.yy / area, front.stress.xy / area};
      return front;
    }
    before = now;
  }
}

Case column_case(BoundaryKind long_sides) {
  Case settings = shale_case();
  settings.boundary.south.kind = settings.boundary.north.kind = long_sides;
  return settings;
}

}  // namespace

TEST_CASE("compression wave in a column in uniaxial strain", "[verification][structure]") {
  const auto front = run_column(column_case(BoundaryKind::roller), 0, 1);
  CHECK(front.arrival == Approx(2.6516e-3).epsilon(tolerance));
  CHECK(front.stress.xx == Approx(-9.428090e6).epsilon(tolerance));
}

TEST_CASE("shear wave in a column", "[verification][structure]") {
  const auto front = run_column(column_case(BoundaryKind::traction), 1, 1);
  const double speed = 2309.401;
  CHECK(front.arrival == Approx(station / speed).epsilon(tolerance));
  CHECK(front.stress.xy == Approx(-2500 * speed * struck_velocity).epsilon(tolerance));
}

TEST_CASE("bar wave in a slab with free faces: the plane-strain modulus rules", "[verification][structure]") {
  const auto front = run_column(column_case(BoundaryKind::traction), 0, 1);
  const double speed = std::sqrt(shale_case().rock.plane_strain_modulus() / 2500);
  CHECK(front.arrival == Approx(station / speed).epsilon(tolerance));
  CHECK(front.stress.xx == Approx(-2500 * speed * struck_velocity).epsilon(tolerance));
}

TEST_CASE("bar wave without Poisson's effect: 3577.709 m/s", "[verification][structure]") {
  Case settings = column_case(BoundaryKind::traction);
  settings.rock.poissons_ratio = 0;
  const auto front = run_column(settings, 0, 1);
  CHECK(front.arrival == Approx(2.7951e-3).epsilon(tolerance));
  CHECK(front.stress.xx == Approx(-8.944272e6).epsilon(tolerance));
}

TEST_CASE("masses scaled by s delay the wave by the square root of s", "[verification][structure]") {
  const double mass_scale = 400;
  const auto front = run_column(column_case(BoundaryKind::roller), 0, mass_scale);
  CHECK(front.arrival == Approx(20 * 2.6516e-3).epsilon(tolerance));
  CHECK(front.stress.xx == Approx(20 * -9.428090e6).epsilon(tolerance));
}
