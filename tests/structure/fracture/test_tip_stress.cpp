// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/tip_stress.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

void displace(GrowingRock& rock, const std::function<Point(const Point&)>& field) {
  for (std::size_t node = 0; node < rock.geometry.mesh.position.size(); ++node) {
    const Point u = field(rock.geometry.mesh.position[node]);
    rock.state.body.displacement[2 * node] = u[0];
    rock.state.body.displacement[2 * node + 1] = u[1];
  }
}

InPlane<double> average(const GrowingRock& rock, const FractureTip& tip, double radius, double width) {
  return average_stress(rock.geometry.mesh, rock.geometry.node_elements, rock.geometry.body,
                        rock.model.moduli, rock.state.body.displacement,
                        {tip.position, tip.node, tip.direction, radius, width});
}

}  // namespace

TEST_CASE("the average of a uniform stress is that stress, pore pressure included", "[structure][fracture]") {
  Case given = free_slit();
  given.in_situ.stress = {-3e6, -5e6, 1e6, -4e6};
  given.in_situ.pore_pressure = 2e6;
  GrowingRock rock(given);
  rock.strain_uniformly({7e6, 1e6, -2e6});
  const InPlane<double> stress = average(rock, rock.tip_near({3, 0}), 0.75, 0.375);
  // The in-situ stress is stored in single precision.
  CHECK(stress.xx == Approx(-3e6 + 7e6 - 2e6).epsilon(1e-6));
  CHECK(stress.yy == Approx(-5e6 + 1e6 - 2e6).epsilon(1e-6));
  CHECK(stress.xy == Approx(1e6 - 2e6).epsilon(1e-6));
}

TEST_CASE("what is beyond a fracture or behind the tip does not count", "[structure][fracture]") {
  Case given = free_slit();
  add_line(given, "wall", FractureKind::natural, {2.9, -2}, {2.9, 2});
  GrowingRock rock(given);
  const FractureTip tip = rock.tip_near({2.5, 0});
  displace(rock, [&](const Point& at) {
    return at[0] < tip.position[0] - 0.3 ? Point{at[0], at[1]} : Point{0, 0};
  });
  const Mesh& mesh = rock.geometry.mesh;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    if (centroid(mesh, element)[0] > 2.9)
      for (const NodeIndex node : mesh.elements[element])
        rock.state.body.displacement[2 * node] = mesh.position[node][0];
  const InPlane<double> stress = average(rock, tip, 0.75, 0.375);
  CHECK(stress.xx == 0);
  CHECK(stress.yy == 0);
  CHECK(stress.xy == 0);
}

TEST_CASE("the weight falls off with the distance as a Gaussian, and to the sides if what is ahead counts",
          "[structure][fracture]") {
  GrowingRock rock(free_slit());
  const FractureTip tip = rock.tip_near({2.5, 0});
  const double width = GENERATE(0.25, 0.5);
  const auto weighting = GENERATE(HalfDisc::Weighting::near, HalfDisc::Weighting::ahead);
  displace(rock, [&](const Point& at) { return Point{0, 1e-6 * (at[0] - tip.position[0]) * at[1]}; });
  // sigma_yy grows with the distance ahead. Of that the half plane has the mean width sqrt(2 / pi), and twice
  // as much with its square as a further weight; the disc ends at 3.5 widths.
  const InPlane<double> stress = average_stress(
      rock.geometry.mesh, rock.geometry.node_elements, rock.geometry.body, rock.model.moduli,
      rock.state.body.displacement, {tip.position, tip.node, tip.direction, 3.5 * width, width, weighting});
  const double mean = stress.yy / ((rock.model.moduli.lame + 2 * rock.model.moduli.shear) * 1e-6);
  const double expected =
      width * std::sqrt(2 / std::numbers::pi) * (weighting == HalfDisc::Weighting::near ? 1 : 2);
  CHECK(mean == Approx(expected).epsilon(0.04));  // one stress in each element, as large as the smaller width
}

TEST_CASE("a disc smaller than an element gives the stress at the tip", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.strain_uniformly({1e6, 2e6, 3e6});
  CHECK(average(rock, rock.tip_near({2.5, 0}), 1e-6, 1e-6).yy == Approx(2e6).epsilon(1e-9));
}
