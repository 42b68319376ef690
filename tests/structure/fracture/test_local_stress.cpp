// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/local_stress.hpp"
#include "tests/structure/fracture/growing_rock.hpp"
#include "tests/structure/fracture/static_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double MPa = 1e6, half_length = 5;
constexpr std::uint32_t hydraulic = 0, other = 2;

/// Sneddon's crack on y = 0 in pieces.
std::vector<DisplacementJump> sneddon_crack(double net_pressure, double modulus) {
  std::vector<DisplacementJump> jumps;
  constexpr int pieces = 400;
  const auto at = [](int i) { return -half_length * std::cos(std::numbers::pi * i / pieces); };
  const auto opening = [&](double x) {
    return 4 * net_pressure / modulus * std::sqrt(std::max(0.0, half_length * half_length - x * x));
  };
  for (int i = 0; i < pieces; ++i)
    jumps.push_back({{at(i), 0}, {at(i + 1), 0}, {0, opening(at(i))}, {0, opening(at(i + 1))}});
  return jumps;
}

/// A fracture one h short of a natural one, and another one beside it.
Case shadowed_case(double distance, double lean) {
  Case given = free_case(200);
  given.mesh.far_size = 20;
  given.mesh.gradation = 0.3;
  given.mesh.corridor = 2;
  given.mesh.fracture_size = given.mesh.tip_size = 0.5;
  given.mesh.tip_radius = 2;
  given.in_situ.stress = {-15 * MPa, -10 * MPa, 0, -20 * MPa};
  add_line(given, "hydraulic", FractureKind::open, {-half_length, 0}, {half_length - 0.5, 0});
  add_line(given, "natural", FractureKind::natural, {half_length - 3 * lean, -3},
           {half_length + 3 * lean, 3});
  add_line(given, "other", FractureKind::open, {-3, distance}, {5, distance});
  return given;
}

/// Displacement with the faces of the hydraulic fracture together and those of the other one apart as in
/// `displacement`.
std::vector<double> with_hydraulic_closed(const GrowingRock& rock, const std::vector<double>& displacement) {
  const Mesh& mesh = rock.geometry.mesh;
  std::vector<Faces> faces(mesh.units.size());
  for (UnitIndex index = 0; index < mesh.units.size(); ++index) {
    const auto [minus, plus] = std::pair(mesh.units[index].minus, mesh.units[index].plus);
    if (mesh.units[index].line == other)
      faces[index].apart = {displacement[2 * plus] - displacement[2 * minus],
                            displacement[2 * plus + 1] - displacement[2 * minus + 1]};
  }
  return displacement_at_rest(mesh, rock.model.moduli, faces);
}

InPlane<double> mean_stress(const GrowingRock& rock, const std::vector<double>& displacement,
                            const Point& place, double radius) {
  InPlane<double> sum{0, 0, 0};
  double area = 0;
  const Mesh& mesh = rock.geometry.mesh;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Point at = centroid(mesh, element);
    if (std::hypot(at[0] - place[0], at[1] - place[1]) > radius) continue;
    const InPlane<double> stress =
        undamaged_stress(mesh, rock.geometry.body, rock.model.moduli, element, displacement).in_plane;
    const double weight = element_area(mesh, element);
    sum.xx += weight * stress.xx, sum.yy += weight * stress.yy, sum.xy += weight * stress.xy;
    area += weight;
  }
  return {sum.xx / area, sum.yy / area, sum.xy / area};
}

}  // namespace

TEST_CASE("the stress of a jump: that of the crack of Sneddon", "[structure][fracture]") {
  const double modulus = 30e9;
  const auto stress_at = [&](Point place) {
    InPlane<double> sum{0, 0, 0};
    for (const DisplacementJump& jump : sneddon_crack(1, modulus)) {
      const InPlane<double> stress = stress_of_jump(jump, 4, modulus, place);
      sum.xx += stress.xx, sum.yy += stress.yy, sum.xy += stress.xy;
    }
    return sum;
  };
  const double a = half_length;
  for (const auto& [y, yy, xx] : {std::tuple{.25, -.985733, -.529196},
                                  {.5, -.910557, -.195016},
                                  {1., -.646447, .060660},
                                  {2., -.284458, .073313},
                                  {8., -.022988, .007544}}) {
    CHECK(stress_at({0, y * a}).yy == Approx(yy).margin(2e-4));
    CHECK(stress_at({0, y * a}).xx == Approx(xx).margin(2e-4));
    CHECK(stress_at({0, y * a}).xy == Approx(0).margin(1e-9));
  }
  for (const auto& [x, yy] : {std::pair{1.05, 2.279649}, {1.2, .809068}, {2., .154701}}) {
    CHECK(stress_at({x * a, 0}).yy == Approx(yy).epsilon(2e-4));
    CHECK(stress_at({x * a, 0}).xx == Approx(yy).epsilon(2e-4));
  }
}

TEST_CASE("the stress at a place is found although the fracture about to reach it is open",
          "[structure][fracture]") {
  const double distance = GENERATE(30., 6.), lean = GENERATE(0., 0.577), pressure = GENERATE(1., 3.), h = 0.5;
  GrowingRock rock(shadowed_case(distance, lean));
  const Mesh& mesh = rock.geometry.mesh;
  std::vector<Faces> faces(mesh.units.size());
  press(mesh, hydraulic, pressure * MPa, faces);
  press(mesh, other, 2 * MPa, faces);
  const auto displacement = displacement_at_rest(mesh, rock.model.moduli, faces);
  const Point place{half_length, 0};
  const VertexIndex tip = rock.tip_near({half_length - h, 0}).vertex;
  const InPlane<double> found =
      local_stress(mesh, rock.geometry.body, rock.model.moduli, displacement, {place, tip, h});

  const InPlane<double> expected = mean_stress(rock, with_hydraulic_closed(rock, displacement), place, 2 * h);
  // The triangles see the hydraulic fracture's field with an error of a few percent of its net pressure, and
  // that of the other one averaged over the ring.
  const double margin = 0.01 * pressure * MPa + 0.03 * MPa;
  CHECK(found.xx == Approx(expected.xx).margin(margin).epsilon(0));
  CHECK(found.yy == Approx(expected.yy).margin(margin).epsilon(0));
  CHECK(found.xy == Approx(expected.xy).margin(margin).epsilon(0));
}

TEST_CASE("faces that hold together have no jump, and natural fractures are not part of what reaches them",
          "[structure][fracture]") {
  Case given = slit_before_natural_fracture();
  given.fractures.front().points.back() = {0, 0};
  GrowingRock rock(given);
  const Mesh& mesh = rock.geometry.mesh;
  const std::vector<double> at_rest(2 * mesh.position.size(), 0);
  const auto at_junction = std::find_if(
      mesh.vertices.begin(), mesh.vertices.end(),
      [](const FractureVertex& vertex) { return std::hypot(vertex.position[0], vertex.position[1]) < 1e-9; });
  REQUIRE(at_junction != mesh.vertices.end());
  double length = 0;
  for (const DisplacementJump& jump :
       jumps_of_fracture(mesh, at_rest, static_cast<VertexIndex>(at_junction - mesh.vertices.begin()))) {
    length += std::hypot(jump.end[0] - jump.begin[0], jump.end[1] - jump.begin[1]);
    CHECK(jump.at_begin == std::array<double, 2>{0, 0});
  }
  CHECK(length == Approx(3));
}
