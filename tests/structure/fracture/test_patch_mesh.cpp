// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "structure/mesh/triangle_shape.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr double degree = std::numbers::pi / 180;

struct Patch {
  PatchOutline outline;
  std::vector<Point> line;
  std::optional<PatchMesh> mesh;
};

/// A patch around a segment from any node.
Patch patch_at(const GrowingRock& rock, NodeIndex node, const std::vector<Point>& line) {
  const Mesh& mesh = rock.geometry.mesh;
  const PatchChoice choice =
      choose_patch(mesh, rock.geometry.node_elements, rock.model.run_case.mesh,
                   {node, line.front(), line.back(), 2.2 * rock.h()}, CoarseElements::refined);
  Patch patch{outline(mesh, choice.elements, fracture_nodes(mesh)), line, std::nullopt};
  patch.mesh = mesh_patch(patch.outline, line, choice.field, 0.3 * rock.h());
  return patch;
}

void require_sound(const Patch& patch) {
  const PatchMesh& mesh = *patch.mesh;
  std::set<PointPair> edges;
  double area = 0, expected = 0, angle = 10, altitude = 1e9;
  for (const PointTriple& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k)
      edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    REQUIRE(twice_area(a, b, c) > 0);
    area += twice_area(a, b, c) / 2;
    angle = std::min(angle, std::asin(shape(a, b, c).sine_of_smallest_angle));
    altitude = std::min(altitude, shape(a, b, c).smallest_altitude);
  }
  for (const auto& t : patch.outline.triangles) expected += twice_area(t[0], t[1], t[2]) / 2;
  REQUIRE(area == Approx(expected).epsilon(1e-12));
  REQUIRE(mesh.smallest_angle == Approx(angle).epsilon(1e-9));
  REQUIRE(mesh.smallest_altitude == Approx(altitude).epsilon(1e-9));

  // Nothing that had to stay has moved or been split.
  for (std::size_t p = 0; p < patch.outline.fixed; ++p) REQUIRE(mesh.points[p] == patch.outline.points[p]);
  for (const PointPair& edge : patch.outline.edges)
    REQUIRE(edges.contains({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}));
  for (std::size_t k = 0; k + 1 < patch.line.size(); ++k) {
    const auto point = [&](const Point& at) {
      return static_cast<std::uint32_t>(
          std::find(mesh.points.begin(), mesh.points.begin() + static_cast<std::ptrdiff_t>(mesh.fixed), at) -
          mesh.points.begin());
    };
    const std::uint32_t a = point(patch.line[k]), b = point(patch.line[k + 1]);
    REQUIRE(edges.contains({std::min(a, b), std::max(a, b)}));
  }
  // A side of the outline has triangles on one side only, whatever lies beyond it.
  REQUIRE(mesh.outline_point.size() == mesh.points.size() - mesh.fixed);
}

/// A number in [low, high) that is the same with every standard library.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Case crowded_rock() {
  Case given = free_case(20);
  given.mesh.far_size = 0.4;
  add_line(given, "a", FractureKind::open, {-6, -3}, {-2, -2});
  add_line(given, "b", FractureKind::natural, {1, 3}, {5, 1});
  add_line(given, "c", FractureKind::open, {3, -4}, {3, 2});
  return given;
}

}  // namespace

TEST_CASE("two hundred patches anywhere keep every edge of their outline and of the fractures in them",
          "[structure][fracture]") {
  const GrowingRock rock(crowded_rock());
  const Mesh& mesh = rock.geometry.mesh;
  std::mt19937_64 random(1);
  int meshed = 0, tried = 0, rough = 0;
  while (tried < 200) {
    const auto node = static_cast<NodeIndex>(random() % mesh.position.size());
    const Point& at = mesh.position[node];
    const double angle = uniform(random, 0, 2 * std::numbers::pi);
    const Point end{at[0] + rock.h() * std::cos(angle), at[1] + rock.h() * std::sin(angle)};
    if (std::max(std::abs(end[0]), std::abs(end[1])) > 9) continue;
    ++tried;
    const Patch patch = patch_at(rock, node, {at, end});
    if (!patch.mesh) continue;
    ++meshed;
    require_sound(patch);
    if (patch.mesh->smallest_angle < 20 * degree) ++rough;
  }
  // Beside a fracture a segment may leave no room for a triangle, or cross it.
  CHECK(meshed >= 180);
  CHECK(rough <= 10);
}

TEST_CASE("a line of many points has all of them as edges", "[structure][fracture]") {
  const GrowingRock rock(free_slit());
  const FractureTip tip = rock.tip_near({2.5, 0});
  std::vector<Point> line{tip.position};
  for (int k = 1; k <= 5; ++k) line.push_back({tip.position[0] + 0.25 * k, 0.02 * k * k});
  const Patch patch = patch_at(rock, tip.node, line);
  REQUIRE(patch.mesh);
  require_sound(patch);
}

TEST_CASE("a patch that is too coarse is refined from its outline to the line", "[structure][fracture]") {
  Case given = free_slit();
  given.mesh.fracture_size = given.mesh.tip_size = 1;
  GrowingRock rock(given);
  rock.model.run_case.mesh.tip_size = 0.25;
  const FractureTip tip = rock.tip_near({2.5, 0});
  const Patch patch = patch_at(rock, tip.node, {tip.position, {tip.position[0] + 0.25, 0}});
  REQUIRE(patch.mesh);
  require_sound(patch);
  CHECK(patch.mesh->triangles.size() > patch.outline.triangles.size());
  const Point end = patch.line.back();
  for (const PointTriple& t : patch.mesh->triangles) {
    const Point &a = patch.mesh->points[t[0]], &b = patch.mesh->points[t[1]], &c = patch.mesh->points[t[2]];
    const double away = std::hypot((a[0] + b[0] + c[0]) / 3 - end[0], (a[1] + b[1] + c[1]) / 3 - end[1]);
    if (away < 0.5) CHECK(std::sqrt(2 / std::numbers::sqrt3 * twice_area(a, b, c)) < 1.5 * rock.h());
  }
}

TEST_CASE("no patch has a line that leaves it or crosses a fracture", "[structure][fracture]") {
  Case given = free_slit();
  add_line(given, "wall", FractureKind::natural, {2.9, -1}, {2.9, 1});
  const GrowingRock rock(given);
  const FractureTip tip = rock.tip_near({2.5, 0});
  const Mesh& mesh = rock.geometry.mesh;
  const PatchChoice choice = choose_patch(mesh, rock.geometry.node_elements, rock.model.run_case.mesh,
                                          {tip.node, tip.position, {2.75, 0}, 0.6}, CoarseElements::refined);
  const PatchOutline around = outline(mesh, choice.elements, fracture_nodes(mesh));
  CHECK(mesh_patch(around, {tip.position, {2.7, 0.1}}, choice.field, 0));
  CHECK_FALSE(mesh_patch(around, {tip.position, {3.2, 0}}, choice.field, 0));
  CHECK_FALSE(mesh_patch(around, {tip.position, {2.5, 4}}, choice.field, 0));
  CHECK_FALSE(mesh_patch(around, {tip.position, {2.2, 0.1}, {2.2, -0.1}}, choice.field, 0));
  CHECK_FALSE(mesh_patch(around, {tip.position, {2.7, 0.1}}, choice.field, 1));  // no triangle is that high
}
