// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/cells/cell_law.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "network/cells/sweep.hpp"
#include "network/exposure.hpp"

using namespace fissura::cells;

namespace {

constexpr CellLaw open_faces{
    .aperture = 3e-4, .compliance = 1e-10, .reference_pressure = 2e6, .bulk_modulus = 2e9};
/// Aperture grows from nothing at 4 MPa.
constexpr CellLaw opening_faces{
    .aperture = 1e-4, .compliance = 1e-10, .reference_pressure = 5e6, .bulk_modulus = 2e9};
constexpr CellLaw touching_faces{
    .aperture = 1e-5, .compliance = 1e-10, .reference_pressure = 5e6, .bulk_modulus = 2e9, .closed = true};
constexpr CellLaw rigid_faces{
    .aperture = 1e-3, .compliance = 0, .reference_pressure = 0, .bulk_modulus = 2e9};

}  // namespace

TEST_CASE("cell: the pressure of a content is that which holds it", "[network][cells]") {
  for (const CellLaw& law : {open_faces, opening_faces, touching_faces, rigid_faces})
    for (const double above : {1e4, 3e6, 2e7}) {
      const double pressure = opening_pressure(law) + above;
      // A content is known to 1e-16 of itself, which in a rigid cell is 2e-7 Pa; twenty times that.
      CHECK(cell_pressure(law, cell_content(law, pressure)) == Approx(pressure).margin(4e-6).epsilon(1e-12));
    }
}

TEST_CASE("cell: what its content does not fill has no pressure, and a filled share below one",
          "[network][cells]") {
  const double content = 0.5 * cell_aperture(open_faces, 0);
  CHECK(cell_pressure(open_faces, content) == 0);
  CHECK(cell_filled(open_faces, 0, content) == Approx(0.5).epsilon(1e-15));
  CHECK(cell_filled(open_faces, 0, cell_aperture(open_faces, 0)) < 1);
}

TEST_CASE("cell: faces that touch open only beyond the pressure that parts them", "[network][cells]") {
  CHECK(cell_aperture(touching_faces, 4.9e6) == touching_faces.aperture);
  CHECK(cell_aperture(touching_faces, 6e6) == Approx(touching_faces.aperture + 1e-4).epsilon(1e-15));
  CHECK(opening_pressure(touching_faces) == 5e6);
}

TEST_CASE("cell: the balanced pressure stores what comes in less what it drives out", "[network][cells]") {
  const double length = 0.5, conductance = 2e-9;
  for (const CellLaw& law : {open_faces, opening_faces, touching_faces, rigid_faces})
    for (const double pressure : {1e3, 2e6, 4.5e6, 3e7}) {
      const double content = 0.9 * law.aperture;
      const double supply = length * (cell_content(law, pressure) - content) + conductance * pressure;
      CHECK(balanced_pressure(law, length, content, conductance, supply) == Approx(pressure).epsilon(1e-9));
    }
  CHECK(balanced_pressure(open_faces, length, 0, conductance, 1e-9) == 0);
}

TEST_CASE("cell: a tip exposes it from its entry to that of the next cell, as in the built-in solver",
          "[network][cells][leak-off]") {
  const fissura::network::CarterLaw law{1e-6, 1e-6};
  std::vector<Sweep> sweeps = {{.begin = 0, .end = 0}, {.begin = 1, .end = 1}, {.begin = 3, .end = 3}};
  enter(1, {0}, sweeps);
  CHECK(leak_off_of(law, sweeps[1], 2) == Approx(2e-6 + 4e-6 * 2 / 3).epsilon(1e-15));
  enter(2, {1}, sweeps);
  CHECK(sweeps[1].end == 3);
  CHECK(sweeps[2].residence == 2);
  using fissura::network::Exposure;
  using fissura::network::Front;
  const Exposure passed{.begin = 1, .end = 3, .residence = 0, .front = Front::passed};
  const Exposure inside{.begin = 3, .end = 3, .residence = 2, .front = Front::inside};
  for (const double time : {3.0, 3.5, 4.9, 5.1, 100.0}) {
    CHECK(leak_off_of(law, sweeps[1], time) == leak_off_demand(law, passed, time));
    CHECK(leak_off_of(law, sweeps[2], time) == leak_off_demand(law, inside, time));
  }
}
