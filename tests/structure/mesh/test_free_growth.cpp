// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "mesh_cases.hpp"
#include "structure/mesh/build_mesh.hpp"
#include "structure/mesh/line_arrangement.hpp"
#include "structure/mesh/mesh_quality.hpp"
#include "structure/mesh/prescribed_points.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

constexpr double least_angle = 20;       // [degrees], of any case here
constexpr double least_altitude = 0.45;  // of the smallest target size

MeshControls controls(double fracture_size, double far_size, double corridor, double gradation) {
  return {fracture_size, far_size, corridor, gradation, 1, fracture_size, 4 * fracture_size, 0.4, {}, {}};
}

/// A slit of 2 m along x whose ends may grow in any direction.
Case free_slit() {
  Case given = square(60);
  given.growth.path = PathRule::free;
  given.mesh = controls(0.25, 6, 2, 0.3);
  add_line(given, "slit", {{-1, 0}, {1, 0}});
  return given;
}

/// The same in rock that is coarse but at the tips.
Case coarse_slit() {
  Case given = free_slit();
  given.mesh = controls(1, 6, 0.1, 0.4);
  given.mesh.tip_size = 0.25;
  given.mesh.tip_radius = 1;
  return given;
}

void check_quality(const Case& given, double finest) {
  const MeshQuality quality = measure(build_mesh(given));
  CHECK(quality.smallest_angle >= least_angle);
  CHECK(quality.smallest_altitude >= least_altitude * finest);
}

std::vector<Point> nodes_ahead(const Mesh& mesh) {
  std::vector<Point> nodes;
  for (const Point& p : mesh.position)
    if (std::hypot(p[0] - 2, p[1]) < 0.9) nodes.push_back(p);
  return nodes;
}

double mean_edge(const Mesh& mesh, const Point& centre, double radius) {
  double sum = 0;
  int count = 0;
  for (const auto& e : mesh.elements)
    for (int k = 0; k < 3; ++k) {
      const Point &p = mesh.position[e[k]], &q = mesh.position[e[(k + 1) % 3]];
      if (distance({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2}, centre) > radius) continue;
      sum += distance(p, q);
      ++count;
    }
  return sum / count;
}

/// |mean of exp(6 i angle)| over the edges near `centre`: 1 for a lattice, about 1 / sqrt(edges) for edges in
/// all directions; and the angle of the lattice.
std::complex<double> hexagonal_order(const Mesh& mesh, const Point& centre, double radius) {
  std::complex<double> sum = 0;
  int count = 0;
  for (const auto& e : mesh.elements)
    for (int k = 0; k < 3; ++k) {
      const Point &p = mesh.position[e[k]], &q = mesh.position[e[(k + 1) % 3]];
      if (distance({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2}, centre) > radius) continue;
      sum += std::polar(1.0, 6 * std::atan2(q[1] - p[1], q[0] - p[0]));
      ++count;
    }
  return sum / static_cast<double>(count);
}

}  // namespace

TEST_CASE("ahead of a growing tip six seeds give six meshes that share no node", "[structure][mesh]") {
  std::vector<std::vector<Point>> seen;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Case given = free_slit();
    given.mesh.seed = seed;
    check_quality(given, 0.25);
    seen.push_back(nodes_ahead(build_mesh(given)));
    REQUIRE(seen.back().size() > 20);
  }
  for (std::size_t a = 0; a < seen.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (const Point& p : seen[a])
        for (const Point& q : seen[b]) REQUIRE(distance(p, q) > 1e-6);
}

// With rows along the line the order is 1 and its phase 0 for every seed.
TEST_CASE("ahead of a growing tip the edges favour no direction over the seeds", "[structure][mesh]") {
  std::complex<double> mean = 0;
  constexpr int seeds = 12;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Case given = free_slit();
    given.mesh.seed = seed;
    const auto order = hexagonal_order(build_mesh(given), {2.2, 0}, 1);
    mean += order / double{seeds};
  }
  CHECK(std::abs(mean) < 0.2);
  Case along = free_slit();
  along.growth.path = PathRule::prescribed;
  CHECK(hexagonal_order(build_mesh(along), {2, 0}, 0.8).real() > 0.9);
}

TEST_CASE("growing tips are the free ends of open lines inside the domain", "[structure][mesh]") {
  Case given = free_slit();
  add_line(given, "to the side", {{-30, 10}, {-20, 10}});
  add_line(given, "natural", {{5, -4}, {5, 4}});
  given.fractures.back().kind = FractureKind::natural;
  add_line(given, "touching", {{5, 2}, {8, 2}});
  const auto tips = growing_tips(arrange_lines(given), given);
  REQUIRE(tips.size() == 4);
  CHECK(tips[0] == Point{-1, 0});
  CHECK(tips[1] == Point{1, 0});
  CHECK(tips[2] == Point{-20, 10});
  CHECK(tips[3] == Point{8, 2});
  given.growth.path = PathRule::prescribed;
  CHECK(growing_tips(arrange_lines(given), given).empty());
}

TEST_CASE("coarse rock is fine at the tips of a slit only", "[structure][mesh]") {
  const Case given = coarse_slit();
  const Mesh mesh = build_mesh(given);
  check_quality(given, given.mesh.tip_size);
  for (const double side : {-1.0, 1.0}) CHECK(mean_edge(mesh, {side, 0}, 1) < 1.25 * given.mesh.tip_size);
  CHECK(mean_edge(mesh, {0, 12}, 2) > 8 * given.mesh.tip_size);
  Case fine = free_slit();
  CHECK(mesh.elements.size() < build_mesh(fine).elements.size() / 2);
}

TEST_CASE("edges on a line are as long as its tips ask for", "[structure][mesh]") {
  Case given = coarse_slit();
  given.fractures.front().points = {{-8, 0}, {8, 0}};
  const Mesh mesh = build_mesh(given);
  double shortest_inside = 1e9, longest_at_tip = 0;
  for (const FractureEdge& edge : mesh.edges) {
    const double from_tip = 8 - std::max(std::abs(mesh.vertices[edge.begin].position[0]),
                                         std::abs(mesh.vertices[edge.end].position[0]));
    if (from_tip < 0.8) longest_at_tip = std::max(longest_at_tip, edge.length);
    if (from_tip > 4) shortest_inside = std::min(shortest_inside, edge.length);
  }
  CHECK(longest_at_tip < 1.1 * given.mesh.tip_size);
  CHECK(shortest_inside > 0.85 * given.mesh.fracture_size);
  check_quality(given, given.mesh.tip_size);
}

TEST_CASE("a refinement holds its size inside and grows outside", "[structure][mesh]") {
  Case given = square(60);
  given.mesh = controls(1, 6, 1, 0.3);
  given.mesh.refinements = {{0.5, -10, 10, -4, 4}};
  const SizeField field(given.mesh, {}, {});
  CHECK(field.size({9, 3}) == 0.5);
  CHECK(field.size({14, 3}) == Approx(0.5 + 0.3 * 4).epsilon(1e-14));
  CHECK(field.size({13, 8}) == Approx(0.5 + 0.3 * 5).epsilon(1e-14));
  const Mesh mesh = build_mesh(given);
  CHECK(mean_edge(mesh, {5, 0}, 3) == Approx(0.5).epsilon(0.1));
  CHECK(mean_edge(mesh, {0, 25}, 3) > 4);
  check_quality(given, 0.5);
}

TEST_CASE("a line that crosses a refinement has its edges", "[structure][mesh]") {
  Case given = square(60);
  given.mesh = controls(1, 6, 2, 0.3);
  given.mesh.refinements = {{0.25, -3, 3, -3, 3}};
  add_line(given, "slit", {{-8, 0.3}, {8, 0.3}});
  const Mesh mesh = build_mesh(given);
  for (const FractureEdge& edge : mesh.edges)
    if (std::abs(mesh.vertices[edge.begin].position[0]) < 2) CHECK(edge.length < 0.3);
  check_quality(given, 0.25);
}

TEST_CASE("where the target size is uniform the points are a lattice at its angle", "[structure][mesh]") {
  const double degrees = GENERATE(0.0, 17.0, 30.0, 45.0);
  Case given = square(40);
  given.mesh = controls(1, 4, 1, 0.3);
  given.mesh.refinements = {{0.5, -8, 8, -6, 6}};
  given.mesh.lattice_angle = degrees * std::numbers::pi / 180;
  const Mesh mesh = build_mesh(given);
  const auto order = hexagonal_order(mesh, {0, 0}, 4);
  CHECK(std::abs(order) > 0.9999);
  CHECK(std::abs(std::arg(order * std::polar(1.0, -6 * *given.mesh.lattice_angle))) < 1e-6);
  CHECK(mean_edge(mesh, {0, 0}, 4) == Approx(0.5).epsilon(1e-9));
  check_quality(given, 0.5);
}

TEST_CASE("a lattice leaves room for a slit at any angle to it", "[structure][mesh]") {
  Case given = free_slit();
  given.mesh.refinements = {{0.25, -6, 6, -3, 3}};
  given.mesh.lattice_angle = GENERATE(0.0, 0.2, 0.4, 0.5);
  check_quality(given, 0.25);
}

TEST_CASE("report: meshes for free growth", "[.][report]") {
  const auto row = [](const char* name, const Case& given) {
    const MeshQuality quality = measure(build_mesh(given));
    fmt::print("{:32} {:9} elements {:6.1f} deg {:8.3f} m smallest altitude\n", name, quality.elements,
               quality.smallest_angle, quality.smallest_altitude);
  };
  row("slit with a corridor", free_slit());
  row("slit, fine at the tips only", coarse_slit());
  Case given = coarse_slit();
  given.mesh.lattice_angle = 0.3;
  given.mesh.refinements = {{0.25, -12, 12, -2, 2}};
  row("lattice in a refinement", given);
}
