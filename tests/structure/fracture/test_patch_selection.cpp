// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "structure/dynamics/triangle.hpp"
#include "structure/mesh/segment_tree.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

PatchChoice choose(const GrowingRock& rock, CoarseElements coarse_elements) {
  const FractureTip tip = rock.tip_near({2.5, 0});
  return choose_patch(rock.geometry.mesh, rock.geometry.node_elements, rock.model.run_case.mesh,
                      {tip.node, tip.position, {tip.position[0] + rock.h(), 0}, 2.2 * rock.h()},
                      coarse_elements);
}

double size(const Mesh& mesh, ElementIndex element) {
  return std::sqrt(4 / std::numbers::sqrt3 * element_area(mesh, element));
}

Case coarse_slit() {
  Case given = free_slit();
  given.mesh.fracture_size = 1;
  given.mesh.tip_size = 0.25;
  return given;
}

}  // namespace

TEST_CASE("where the mesh is fine the patch is the elements around the segment", "[structure][fracture]") {
  const GrowingRock rock(free_slit());
  const Mesh& mesh = rock.geometry.mesh;
  const PatchChoice choice = choose(rock, CoarseElements::refined);
  REQUIRE(std::is_sorted(choice.elements.begin(), choice.elements.end()));
  REQUIRE(std::adjacent_find(choice.elements.begin(), choice.elements.end()) == choice.elements.end());
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const bool near = distance_to_segment(centroid(mesh, element), {2.5, 0}, {2.75, 0}) <= 2.2 * rock.h();
    CHECK(std::binary_search(choice.elements.begin(), choice.elements.end(), element) == near);
  }
  CHECK(choice.field.size({2.6, 0.1}) == 0.25);
}

TEST_CASE("elements too coarse for a tip belong to the patch unless they are to be left",
          "[structure][fracture]") {
  Case given = coarse_slit();
  given.mesh.tip_size = 1;  // the mesh as it is far from any tip
  GrowingRock rock(given);
  rock.model.run_case.mesh.tip_size = 0.25;
  const Mesh& mesh = rock.geometry.mesh;
  const PatchChoice refined = choose(rock, CoarseElements::refined),
                    left = choose(rock, CoarseElements::left);
  CHECK(refined.elements.size() > left.elements.size());
  CHECK(std::includes(refined.elements.begin(), refined.elements.end(), left.elements.begin(),
                      left.elements.end()));
  // What stays is never much coarser than the field asks for.
  const TipSizeField needed(rock.model.run_case.mesh, {2.5, 0}, {2.75, 0});
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    if (!std::binary_search(refined.elements.begin(), refined.elements.end(), element))
      CHECK(size(mesh, element) <= 2 * needed.size(centroid(mesh, element)));
}

TEST_CASE("a patch does not reach through a fracture", "[structure][fracture]") {
  Case given = free_slit();
  add_line(given, "wall", FractureKind::natural, {2.9, -4}, {2.9, 4});
  const GrowingRock rock(given);
  const auto elements = choose(rock, CoarseElements::refined).elements;
  REQUIRE_FALSE(elements.empty());
  for (const ElementIndex element : elements) CHECK(centroid(rock.geometry.mesh, element)[0] < 2.9);
}
