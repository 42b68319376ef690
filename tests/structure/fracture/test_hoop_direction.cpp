// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "structure/fracture/hoop_direction.hpp"
#include "tests/structure/fracture/growing_rock.hpp"
#include "tests/structure/fracture/static_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double degree = std::numbers::pi / 180, h = 0.25;

/// A slit at `angle` from x with its tip of interest at half its length; the mesh around is as irregular as
/// any.
Case inclined_slit(double angle, double half_length, std::uint64_t seed, FractureKind kind) {
  Case given = free_case(60 * half_length);
  given.mesh.far_size = 6 * half_length;
  given.mesh.gradation = 0.2;
  given.mesh.seed = seed;
  const double x = half_length * std::cos(angle), y = half_length * std::sin(angle);
  add_line(given, "slit", kind, {-x, -y}, {x, y});
  return given;
}

FractureEnd end_of(const GrowingRock& rock, double angle, double half_length) {
  const Point place{half_length * std::cos(angle), half_length * std::sin(angle)};
  for (const FractureVertex& vertex : rock.geometry.mesh.vertices)
    if (std::hypot(vertex.position[0] - place[0], vertex.position[1] - place[1]) < 1e-6)
      return {vertex.position, vertex.node, {std::cos(angle), std::sin(angle)}, h};
  FAIL("no end");
  return {};
}

/// Displacement of the singular field at (r, theta) in its own frame [m]. Westergaard; Tada, Paris and Irwin.
std::array<double, 2> singular_displacement(const StressIntensity& k, const Rock& rock, double r,
                                            double theta) {
  const double shear = rock.youngs_modulus / (2 * (1 + rock.poissons_ratio)),
               kappa = 3 - 4 * rock.poissons_ratio;
  const double factor = std::sqrt(r / (2 * std::numbers::pi)) / (2 * shear), s = std::sin(theta / 2),
               c = std::cos(theta / 2);
  return {factor * (k.opening * c * (kappa - 1 + 2 * s * s) + k.sliding * s * (kappa + 1 + 2 * c * c)),
          factor * (k.opening * s * (kappa + 1 - 2 * c * c) - k.sliding * c * (kappa - 1 - 2 * s * s))};
}

/// Gives every node the displacement of that field around `end`, upper and lower faces apart.
void displace(GrowingRock& rock, const FractureEnd& end, const StressIntensity& k) {
  const Mesh& mesh = rock.geometry.mesh;
  std::vector<int> face(mesh.position.size(), 0);
  for (const ContactUnit& unit : mesh.units) face[unit.plus] = 1, face[unit.minus] = -1;
  const double c = end.direction[0], s = end.direction[1];
  for (NodeIndex node = 0; node < mesh.position.size(); ++node) {
    const double dx = mesh.position[node][0] - end.centre[0], dy = mesh.position[node][1] - end.centre[1];
    const double x = c * dx + s * dy, y = c * dy - s * dx;
    const double theta = face[node] != 0 && x < 0 ? face[node] * std::numbers::pi : std::atan2(y, x);
    const auto u = singular_displacement(k, rock.model.run_case.rock, std::hypot(x, y), theta);
    rock.state.body.displacement[2 * node] += c * u[0] - s * u[1];
    rock.state.body.displacement[2 * node + 1] += s * u[0] + c * u[1];
  }
}

StressIntensity intensity(const GrowingRock& rock, const FractureEnd& end) {
  return stress_intensity(rock.geometry.mesh, rock.geometry.node_elements, rock.geometry.body,
                          rock.model.moduli, rock.state.body.displacement, end);
}

Kink kink(const GrowingRock& rock, const FractureEnd& end) {
  return greatest_hoop_kink(rock.geometry.mesh, rock.geometry.node_elements, rock.geometry.body,
                            rock.model.moduli, rock.state.body.displacement, end);
}

double turn(const Kink& kink, const FractureEnd& end) {
  return std::atan2(end.direction[0] * kink.direction[1] - end.direction[1] * kink.direction[0],
                    end.direction[0] * kink.direction[0] + end.direction[1] * kink.direction[1]) /
         degree;
}

}  // namespace

TEST_CASE("a fracture whose faces slide kinks by 70.53 degrees, one that is pulled apart goes straight on",
          "[structure][fracture]") {
  const double kink = 2 * std::atan(std::sqrt(2.0) / 2);
  CHECK(kink / degree == Approx(70.5288).epsilon(1e-6));
  CHECK(greatest_hoop_angle({0, 2}) == Approx(-kink));
  CHECK(greatest_hoop_angle({0, -2}) == Approx(kink));
  CHECK(greatest_hoop_angle({-1, -2}) == Approx(kink));  // pressed together
  CHECK(greatest_hoop_angle({1, 0}) == 0);
  // The hoop stress cos(theta / 2) (K_I cos^2(theta / 2) - 3 / 2 K_II sin(theta)) has its maximum there.
  const auto hoop = [](double theta) {
    const double c = std::cos(theta / 2);
    return c * (2 * c * c - 1.5 * 1 * std::sin(theta));
  };
  const double angle = greatest_hoop_angle({2, 1});
  CHECK(hoop(angle) > hoop(angle + 0.01));
  CHECK(hoop(angle) > hoop(angle - 0.01));
}

TEST_CASE("the kink found in the triangles around an end: singular fields", "[structure][fracture]") {
  const double angle = GENERATE(0., 30., 53.) * degree;
  const std::uint64_t seed = GENERATE(range(1, 7));
  GrowingRock rock(inclined_slit(angle, 5, seed, FractureKind::open));
  const FractureEnd end = end_of(rock, angle, 5);
  // One stress in each triangle: intensities within a tenth, the wrong one within a thirtieth.
  SECTION("sliding") {
    displace(rock, end, {0, 1e6});
    CHECK(intensity(rock, end).sliding == Approx(1e6).epsilon(0.1));
    CHECK(std::abs(intensity(rock, end).opening) < 1e6 / 30);
    CHECK(turn(kink(rock, end), end) == Approx(-70.5288).margin(1));
  }
  SECTION("opening") {
    displace(rock, end, {1e6, 0});
    CHECK(intensity(rock, end).opening == Approx(1e6).epsilon(0.1));
    CHECK(std::abs(intensity(rock, end).sliding) < 1e6 / 30);
    CHECK(turn(kink(rock, end), end) == Approx(0).margin(4));
  }
}

TEST_CASE("the kink of a closed fracture in compression, which its own faces press on",
          "[structure][fracture]") {
  const double angle = GENERATE(36.65, 60.) * degree, half_length = 5, pressure = 20e6, friction = 0.3;
  Case given = inclined_slit(angle, half_length, 1, FractureKind::open);
  given.in_situ.stress = {-pressure, 0, 0, 0};
  GrowingRock rock(given);
  const FractureEnd end = end_of(rock, angle, half_length);
  const double normal = pressure * std::pow(std::sin(angle), 2);
  const double excess = pressure * std::sin(angle) * std::cos(angle) - friction * normal;
  std::vector<Faces> faces(rock.geometry.mesh.units.size());
  for (Faces& pair : faces) pair = {false, {}, {excess * std::cos(angle), excess * std::sin(angle)}};
  rock.state.body.displacement = displacement_at_rest(rock.geometry.mesh, rock.model.moduli, faces);
  CHECK(turn(kink(rock, end), end) == Approx(-70.5288).margin(1));
  // 20 elements in half the length: the triangles are too stiff around the end.
  CHECK(intensity(rock, end).sliding ==
        Approx(0.86 * excess * std::sqrt(std::numbers::pi * half_length)).epsilon(0.04));
  CHECK(kink(rock, end).stress > 0);
}

TEST_CASE("wing cracks start from both ends of a flaw at 70.53 degrees, towards the load",
          "[structure][fracture]") {
  const double angle = 36.65 * degree, half_length = 5;
  const std::uint64_t seed = GENERATE(range(1, 4));
  Case given = inclined_slit(angle, half_length, seed, FractureKind::natural);
  given.in_situ.stress = {-20e6, 0, 0, 0};
  GrowingRock rock(given);
  std::vector<Faces> faces(rock.geometry.mesh.units.size());
  for (Faces& pair : faces) pair = {false, {}, {7e6 * std::cos(angle), 7e6 * std::sin(angle)}};
  rock.state.body.displacement = displacement_at_rest(rock.geometry.mesh, rock.model.moduli, faces);
  for (JointState& state : rock.state.joints.state) state.slip = 1e-3;
  rock.insert(rock.plan());
  const Mesh& mesh = rock.geometry.mesh;
  int wings = 0;
  for (const FractureEdge& edge : mesh.edges) {
    if (mesh.lines[edge.line].name != "growth of slit") continue;
    const Point &from = mesh.vertices[edge.begin].position, &to = mesh.vertices[edge.end].position;
    const double outward = from[0] > 0 ? 1 : -1;
    const double wing = std::atan2(outward * (to[1] - from[1]), outward * (to[0] - from[0]));
    CHECK((wing - angle) / degree == Approx(-70.5288).margin(1));
    ++wings;
  }
  CHECK(wings == 2);
}

TEST_CASE("the stress across a kink is the total one of its surroundings", "[structure][fracture]") {
  Case given = inclined_slit(0, 5, 1, FractureKind::open);
  given.in_situ.stress = {-3e6, -5e6, 0, -4e6};
  given.in_situ.pore_pressure = 2e6;
  GrowingRock rock(given);
  rock.strain_uniformly({7e6, 1e6, 0});
  const FractureEnd end = end_of(rock, 0, 5);
  const Kink found = kink(rock, end);
  const double xx = -3e6 + 7e6 - 2e6, yy = -5e6 + 1e6 - 2e6, angle = turn(found, end) * degree;
  // The in-situ stress is stored in single precision.
  CHECK(found.stress ==
        Approx(xx * std::pow(std::sin(angle), 2) + yy * std::pow(std::cos(angle), 2)).epsilon(1e-6));
}
