// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/fracture_path.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <optional>

#include "coupler/scheme/fracture_extent.hpp"
#include "coupler/scheme/interval_figures.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double rounding = 1e-12;  // of a few additions and a quotient of numbers near one

/// Builds a network by hand: nodes are numbered in the order in which they are added.
class Sketch {
 public:
  NodeId node(double x, double y) {
    insertion_.new_nodes.push_back({.id = count_, .x = x, .y = y, .lumped_length = 1});
    return count_++;
  }
  void segment(NodeId a, NodeId b, SegmentKind kind) {
    const NetworkNode &from = insertion_.new_nodes[a], &to = insertion_.new_nodes[b];
    insertion_.new_segments.push_back({.id = insertion_.new_segments.size(),
                                       .node_a = a,
                                       .node_b = b,
                                       .kind = kind,
                                       .length = std::hypot(to.x - from.x, to.y - from.y)});
  }
  /// Adds a chain of points to `from`; returns its last node.
  NodeId grow(NodeId from, const std::vector<Point>& points) {
    for (const Point& point : points) {
      const NodeId next = node(point[0], point[1]);
      segment(from, next, SegmentKind::hydraulic);
      from = next;
    }
    return from;
  }
  [[nodiscard]] FractureNetwork network() const {
    FractureNetwork result;
    result.apply(insertion_);
    return result;
  }

 private:
  Insertion insertion_;
  NodeId count_ = 0;
};

/// A slit along x from -1 to 1 with its five nodes; east and west are its ends.
struct Slit {
  Sketch sketch;
  NodeId west, east;
  Slit() {
    west = sketch.node(-1, 0);
    east = sketch.grow(west, {{-0.5, 0}, {0, 0}, {0.5, 0}, {1, 0}});
  }
};

Case slit_case(double maximum, double minimum, double axis_angle) {
  Case value;
  value.mesh.fracture_size = 0.5;
  value.rock.fracture_energy = 50;
  value.domain.thickness = 2;
  value.fractures.push_back({.name = "slit", .kind = FractureKind::open, .points = {{-1, 0}, {1, 0}}, .set = {}});
  value.injection.perforations = {{"perforation", {0, 0}, 1e-5}};
  const double mean = -(maximum + minimum) / 2, half = (maximum - minimum) / 2;
  value.in_situ.stress = {mean - half * std::cos(2 * axis_angle), mean + half * std::cos(2 * axis_angle),
                          -half * std::sin(2 * axis_angle), mean};
  return value;
}

const Case isotropic_case = slit_case(10e6, 10e6, 0);

}  // namespace

TEST_CASE("a slit that has not grown has no path", "[coupler][scheme][path]") {
  const FracturePath path = fracture_path(Slit().sketch.network(), isotropic_case);
  CHECK(path.grown.empty());
  CHECK(path.deviation == 0);
  CHECK(path.first_angle == 0);
}

TEST_CASE("a slit may still be closed at its ends: the segment to the end belongs to the slit",
          "[coupler][scheme][path]") {
  Sketch sketch;
  sketch.grow(sketch.node(-0.5, 0), {{0, 0}, {0.5, 0}});
  CHECK(fracture_path(sketch.network(), isotropic_case).grown.empty());
}

TEST_CASE("straight wings along the slit deviate nowhere", "[coupler][scheme][path]") {
  Slit slit;
  slit.sketch.grow(slit.east, {{1.5, 0}, {2, 0}});
  slit.sketch.grow(slit.west, {{-1.5, 0}});
  const FracturePath path = fracture_path(slit.sketch.network(), isotropic_case);
  CHECK(path.grown == std::vector<std::size_t>{4, 5, 6});
  CHECK(path.deviation == 0);
  CHECK(path.chord_angle == 0);
  CHECK(path.first_angle == 0);
  CHECK(path.end_angle == 0);
}

TEST_CASE("deviation and chord are of the wing that is worse, on either side", "[coupler][scheme][path]") {
  Slit slit;
  slit.sketch.grow(slit.east, {{2, 0.1}, {3, -0.2}, {4, 0}});
  slit.sketch.grow(slit.west, {{-2, 0}, {-3, 0.15}});
  const FracturePath path = fracture_path(slit.sketch.network(), isotropic_case);
  CHECK(path.deviation == Approx(0.2).epsilon(rounding));
  CHECK(path.chord_angle == Approx(std::atan2(0.15, 2)).epsilon(rounding));
  CHECK(path.first_angle == Approx(std::atan2(0.1, 1)).epsilon(rounding));
}

TEST_CASE("first and end angle count from the axis of greatest compression, whatever its quadrant",
          "[coupler][scheme][path]") {
  const double axis = GENERATE(10., 40., 80., 100., 140., 170.) * degree;
  CAPTURE(axis);
  Slit slit;
  const double turn = 3 * degree;
  const auto on = [](double x, double length, double angle) {
    return Point{x + length * std::cos(angle), length * std::sin(angle)};
  };
  const double east = axis <= 90 * degree ? axis : axis - std::numbers::pi;
  slit.sketch.grow(slit.east, {on(1, 0.5, east + turn), on(1, 1, east)});
  slit.sketch.grow(slit.west, {on(-1, -0.5, east), on(-1, -1, east)});
  const FracturePath path = fracture_path(slit.sketch.network(), slit_case(15e6, 10e6, axis));
  CHECK(path.first_angle == Approx(turn).epsilon(1e-9));  // an arctangent near 1 loses some digits
  CHECK(path.end_angle == Approx(0).margin(1e-9));
  CHECK(path.chord_angle == Approx(std::abs(east)).epsilon(1e-9));
}

TEST_CASE("the end is the chord over the last three segments", "[coupler][scheme][path]") {
  Slit slit;
  slit.sketch.grow(slit.east, {{2, 1}, {3, 1}, {4, 1.3}, {5, 1.6}});
  const FracturePath path = fracture_path(slit.sketch.network(), isotropic_case);
  CHECK(path.first_angle == Approx(45 * degree).epsilon(rounding));
  CHECK(path.end_angle == Approx(std::atan2(0.6, 3)).epsilon(rounding));
}

TEST_CASE("natural fractures and other slits are not grown, and a wing goes straight on at a fork",
          "[coupler][scheme][path]") {
  Slit slit;
  const NodeId fork = slit.sketch.grow(slit.east, {{2, 0}});
  const NodeId joint = slit.sketch.node(2.5, 2);
  slit.sketch.segment(fork, joint, SegmentKind::natural);
  slit.sketch.grow(fork, {{2.5, -0.5}});
  slit.sketch.grow(fork, {{3, 0.1}});
  slit.sketch.grow(slit.sketch.node(0, 5), {{1, 5}});
  Case value = isotropic_case;
  value.fractures.push_back({.name = "second", .kind = FractureKind::open, .points = {{0, 5}, {1, 5}}, .set = {}});
  const FracturePath path = fracture_path(slit.sketch.network(), value);
  CHECK(path.grown == std::vector<std::size_t>{4, 6, 7});
  CHECK(path.deviation == Approx(0.1).epsilon(rounding));
}

TEST_CASE("the perforated slit decides; without perforations the first open one", "[coupler][scheme][path]") {
  Slit slit;
  slit.sketch.grow(slit.east, {{2, 1}});
  Case value = isotropic_case;
  value.fractures.insert(value.fractures.begin(),
                         {.name = "other", .kind = FractureKind::open, .points = {{0, 5}, {1, 5}}, .set = {}});
  CHECK(fracture_path(slit.sketch.network(), value).first_angle == Approx(45 * degree).epsilon(rounding));
  value.injection.perforations.clear();
  CHECK(fracture_path(slit.sketch.network(), value).first_angle == 0);
}

TEST_CASE("without any open line everything hydraulic has grown, and there are no wings",
          "[coupler][scheme][path]") {
  Sketch sketch;
  sketch.grow(sketch.node(0, 0), {{1, 1}, {2, 1}});
  Case value = isotropic_case;
  value.fractures.clear();
  const FracturePath path = fracture_path(sketch.network(), value);
  CHECK(path.grown.size() == 2);
  CHECK(path.chord_angle == 0);
}

TEST_CASE("a bent fracture is as long as its trace", "[coupler][scheme][path]") {
  Slit slit;
  slit.sketch.grow(slit.east, {{1, 3}, {5, 6}});
  CHECK(half_length(slit.sketch.network()) == Approx((2 + 3 + 5) / 2.).epsilon(rounding));
}

TEST_CASE("the cohesive share counts broken joints of the grown fracture whole, others that have opened half",
          "[coupler][scheme][path]") {
  Slit slit;
  slit.sketch.grow(slit.east, {{2, 0}, {3, 0}, {4, 0}});
  const FractureNetwork network = slit.sketch.network();
  const FracturePath path = fracture_path(network, isotropic_case);
  StructureResponse structure;
  structure.closed = {0, 0, 0, 0, 0, 0, 0, 1};
  structure.broken = {1, 1, 1, 1, 1, 1, 0, 0};
  structure.cohesive_work = 120;
  structure.failure_work = 7;
  structure.elements = 4321;
  // Every node stands for 1 m: the end of the slit and one more are broken, one is opened, one is closed.
  IntervalRecord record;
  add_growth_figures(network, path, structure, isotropic_case, record);
  CHECK(record.cohesive_share == Approx(120 / 250.).epsilon(rounding));
  CHECK(record.cohesive_work == 120);
  CHECK(record.failure_work == 7);
  CHECK(record.elements == 4321);
}
