// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/nucleation.hpp"
#include "structure/fracture/tip_corridor.hpp"
#include "structure/mesh/segment_tree.hpp"
#include "tests/structure/fracture/failing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

constexpr Point east_tip{2.5, 0};

// A band ahead of the east tip, on y = 0.
std::function<bool(const Point&)> band(double length, double half_width) {
  return [=](const Point& at) {
    return at[0] > east_tip[0] && at[0] < east_tip[0] + length && std::abs(at[1]) < half_width;
  };
}

double angle(const Point& from, const Point& to) {
  return std::atan2(to[1] - from[1], to[0] - from[0]);
}

}  // namespace

TEST_CASE("failure map: holds the share of strength lost, which is far below the damage",
          "[structure][fracture]") {
  GrowingRock rock(failing_slit());
  fail(rock, 0.6, band(1, 0.2));
  const FailureMap found = map(rock);
  const auto records = damage_records(rock.geometry.tiles, rock.state.body.damage);
  REQUIRE_FALSE(records.empty());
  for (const ElementDamage& record : records) {
    CHECK(found.lost(record.element) == Approx(0.6).epsilon(1e-9));  // rounding
    CHECK(record.history.damage > 0.9);
  }
  CHECK(found.failed(0.61).empty());
  CHECK(found.failed(0.59).size() == records.size());
}

TEST_CASE("march: turns at once across a uniform tension and then keeps its direction",
          "[structure][fracture]") {
  GrowingRock rock(failing_slit());
  const FractureTip tip = rock.tip_near(east_tip);
  rock.pull_across(0.5);
  const std::vector<Point> points = march(now(rock), {tip.position, tip.node, tip.direction}, 6);
  REQUIRE(points.size() == 7);
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    CHECK(angle(points[k], points[k + 1]) == Approx(0.5).epsilon(1e-6));  // single-precision in-situ stress
  CHECK(std::hypot(points[6][0] - points[0][0], points[6][1] - points[0][1]) == Approx(3 * rock.h()));
}

TEST_CASE("march: turns no more than the limit altogether", "[structure][fracture]") {
  Case given = failing_slit();
  given.growth.turn_limit = 0.6;
  GrowingRock rock(given);
  const FractureTip tip = rock.tip_near(east_tip);
  rock.pull_across(1.2);
  const std::vector<Point> points = march(now(rock), {tip.position, tip.node, tip.direction}, 6);
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    CHECK(std::abs(angle(points[k], points[k + 1])) < 0.6 + 1e-9);
}

TEST_CASE("march: stops at a side of the domain", "[structure][fracture]") {
  GrowingRock rock(failing_slit());
  const FractureTip tip = rock.tip_near(east_tip);
  rock.pull_across(0);
  const std::vector<Point> points = march(now(rock), {tip.position, tip.node, tip.direction}, 1000);
  CHECK(points.back()[0] < rock.model.run_case.domain.width / 2);
  CHECK(points.size() < 1000);
}

TEST_CASE("failure path: a tip advances through rock that has failed far enough, and only there",
          "[structure][fracture]") {
  GrowingRock rock(failing_slit());
  const FractureTip east = rock.tip_near(east_tip), west = rock.tip_near({-2.5, 0});
  const double h = rock.h();
  rock.pull_across(0);
  SECTION("nothing has failed") {
    CHECK_FALSE(failure_path(now(rock), map(rock), east));
  }
  SECTION("not failed enough") {
    fail(rock, 0.65, band(3 * h, h));
    CHECK_FALSE(failure_path(now(rock), map(rock), east));
  }
  SECTION("not far enough") {
    fail(rock, 0.9, band(0.6 * h, h));
    CHECK_FALSE(failure_path(now(rock), map(rock), east));
  }
  SECTION("as far as it has failed") {
    fail(rock, 0.9, band(3.2 * h, h));
    const auto path = failure_path(now(rock), map(rock), east);
    REQUIRE(path);
    CHECK(path->size() == 3);
    CHECK(path->back().position[0] == Approx(2.5 + 3 * h).epsilon(1e-6));
    CHECK(path->back().position[1] == Approx(0).margin(1e-6));
    CHECK_FALSE(failure_path(now(rock), map(rock), west));
  }
  SECTION("no farther than four segments") {
    fail(rock, 0.9, band(9 * h, h));
    CHECK(failure_path(now(rock), map(rock), east).value().size() == 4);
  }
}

TEST_CASE("failure path: ends on a natural fracture", "[structure][fracture]") {
  Case given = failing_slit();
  add_line(given, "fault", FractureKind::natural, {2.9, -2}, {2.9, 2});
  GrowingRock rock(given);
  rock.pull_across(0);
  fail(rock, 0.9, band(2 * rock.h(), rock.h()));
  const auto path = failure_path(now(rock), map(rock), rock.tip_near(east_tip));
  REQUIRE(path);
  CHECK(path->back().kind == SegmentEnd::Kind::fracture);
  CHECK(path->back().position[0] == Approx(2.9));
}

TEST_CASE("corridor: failure may start beside the predicted path and nowhere else around a tip",
          "[structure][fracture]") {
  GrowingRock rock(failing_slit());
  rock.pull_across(0);
  const std::vector<ElementIndex> forbidden = tip_corridors(now(rock)).forbidden;
  const Mesh& mesh = rock.geometry.mesh;
  const double h = rock.h();
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Point at = centroid(mesh, element);
    const bool found = std::binary_search(forbidden.begin(), forbidden.end(), element);
    for (const double side : {1, -1}) {
      const double ahead = side * at[0] - 2.5, away = std::hypot(ahead, at[1]);
      if (ahead > 0 && away < 6 * h && std::abs(at[1]) < 0.69 * h) CHECK_FALSE(found);
      if (away < 6.5 * h && std::abs(at[1]) > 0.71 * h) CHECK(found);
    }
    if (std::abs(std::abs(at[0]) - 2.5) > 9 * h || std::abs(at[1]) > 9 * h) CHECK_FALSE(found);
  }
}

TEST_CASE("nucleation: a failed cluster away from fractures becomes a line along its crack",
          "[structure][fracture]") {
  Case given = failing_slit();
  given.mesh.refinements = {{0.25, -2.5, 2.5, 1, 7}};
  GrowingRock rock(given);
  rock.pull_across(0.3);
  const double h = rock.h();
  const auto cluster = [&](const Point& middle, double half_length) {
    return [=](const Point& at) {
      const double x = at[0] - middle[0], y = at[1] - middle[1];
      const double along = x * std::cos(0.3) + y * std::sin(0.3),
                   across = y * std::cos(0.3) - x * std::sin(0.3);
      return std::abs(along) < half_length && std::abs(across) < h;
    };
  };
  SECTION("long enough") {
    fail(rock, 0.8, cluster({0, 4}, 2.5 * h));
    const std::vector<Nucleus> found = nuclei(now(rock), map(rock));
    REQUIRE(found.size() == 1);
    REQUIRE(found[0].line.size() >= 3);
    for (std::size_t k = 0; k + 1 < found[0].line.size(); ++k) {
      const double turned = std::abs(angle(found[0].line[k], found[0].line[k + 1]) - 0.3);
      CHECK(std::min(turned, std::abs(turned - M_PI)) < 1e-6);
    }
    CHECK(std::hypot(found[0].line[found[0].line.size() / 2][0],
                     found[0].line[found[0].line.size() / 2][1] - 4) < 2 * h);
  }
  SECTION("not failed enough") {
    fail(rock, 0.6, cluster({0, 4}, 2.5 * h));
    CHECK(nuclei(now(rock), map(rock)).empty());
  }
  SECTION("too short") {
    fail(rock, 0.8, cluster({0, 4}, 0.4 * h));
    CHECK(nuclei(now(rock), map(rock)).empty());
  }
  SECTION("beside a fracture") {
    fail(rock, 0.8, cluster({0, 1.5 * h}, 2.5 * h));
    CHECK(nuclei(now(rock), map(rock)).empty());
  }
}
