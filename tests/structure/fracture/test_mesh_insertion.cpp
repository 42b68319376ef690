// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/mesh_insertion.hpp"
#include "structure/mesh/segment_tree.hpp"
#include "tests/structure/fracture/growing_rock.hpp"
#include "tests/structure/fracture/mesh_faults.hpp"

using namespace fissura;
using namespace fissura::structure;
using namespace fissura::structure::fakes;

namespace {

/// A mesh finer than its tips ask for: a patch makes fewer elements than it removes.
GrowingRock fine_rock() {
  GrowingRock rock(free_slit());
  rock.model.run_case.mesh.tip_size = 0.33;
  rock.pull_across(0);
  return rock;
}

/// What a change says, compared with the two meshes.
void require_true(const MeshChange& change, const Mesh& before, const Mesh& after) {
  REQUIRE(change.elements_before == before.elements.size());
  REQUIRE(change.nodes_before == before.position.size());
  std::set<ElementIndex> gone(change.removed.begin(), change.removed.end());
  std::set<ElementIndex> other(change.made.begin(), change.made.end());
  std::vector<ElementIndex> place(before.elements.size());
  for (ElementIndex element = 0; element < place.size(); ++element) place[element] = element;
  for (const MovedElement& moved : change.moved) {
    REQUIRE_FALSE(gone.contains(moved.from));
    REQUIRE(moved.to < after.elements.size());
    REQUIRE(moved.from >= after.elements.size());
    place[moved.from] = moved.to;
  }
  std::set<ElementIndex> taken = other;
  for (ElementIndex element = 0; element < place.size(); ++element) {
    if (gone.contains(element)) continue;
    REQUIRE(taken.insert(place[element]).second);
    const bool rewired = std::binary_search(change.rewired.begin(), change.rewired.end(), place[element]);
    REQUIRE((after.elements.at(place[element]) != before.elements[element]) == rewired);
    for (int k = 0; k < 3; ++k)
      REQUIRE(after.position[after.elements[place[element]][k]] ==
              before.position[before.elements[element][k]]);
  }
  REQUIRE(taken.size() == after.elements.size());  // dense

  std::set<NodeIndex> used_before, used_after;
  for (const auto& element : before.elements) used_before.insert(element.begin(), element.end());
  for (const auto& element : after.elements) used_after.insert(element.begin(), element.end());
  for (NodeIndex node = 0; node < after.position.size(); ++node) {
    const bool is_new = std::binary_search(change.new_nodes.begin(), change.new_nodes.end(), node);
    if (!used_before.contains(node) && used_after.contains(node)) REQUIRE(is_new);
    if (used_before.contains(node) && used_after.contains(node) && !is_new)
      REQUIRE(after.position[node] == before.position[node]);
    const bool vanished = std::binary_search(change.unused_nodes.begin(), change.unused_nodes.end(), node);
    REQUIRE(vanished == (used_before.contains(node) && !used_after.contains(node)));
  }
  for (const NodeIndex node : change.touched_nodes) REQUIRE(used_after.contains(node));
  for (const ElementIndex element : change.made)
    for (const NodeIndex node : after.elements[element])
      REQUIRE(std::binary_search(change.touched_nodes.begin(), change.touched_nodes.end(), node));
}

void require_sound(const Mesh& mesh, const Domain& domain) {
  const auto faults = mesh_faults(mesh, domain);
  for (const std::string& fault : faults) UNSCOPED_INFO(fault);
  REQUIRE(faults.empty());
}

}  // namespace

TEST_CASE("an insertion says all that it changed in the mesh", "[structure][fracture]") {
  GrowingRock rock(free_slit());
  rock.pull_across(0.3);
  for (int k = 0; k < 4; ++k) {
    const GrowthPlan plan = rock.plan();
    const Mesh before = rock.geometry.mesh;
    Mesh after = before;
    const MeshInsertion insertion = insert_into_mesh(plan, after);
    require_true(insertion.change, before, after);
    require_sound(after, rock.model.run_case.domain);
    rock.insert(plan);
    REQUIRE(rock.geometry.mesh.elements == after.elements);
    rock.pull_across(0.3);
  }
}

TEST_CASE("elements move into the places left over, and new nodes take the places of old ones",
          "[structure][fracture]") {
  GrowingRock rock = fine_rock();
  const GrowthPlan first = rock.plan();
  Mesh mesh = rock.geometry.mesh;
  const MeshInsertion insertion = insert_into_mesh(first, mesh);
  REQUIRE(insertion.change.made.size() < insertion.change.removed.size());
  CHECK(insertion.change.moved.size() > 0);
  REQUIRE_FALSE(mesh.unused_nodes.empty());
  require_true(insertion.change, rock.geometry.mesh, mesh);
  require_sound(mesh, rock.model.run_case.domain);

  rock.insert(first);
  const NodeIndex lowest = rock.geometry.mesh.unused_nodes.front();
  rock.model.run_case.mesh.tip_size = 0.15;  // now it needs more than are free
  rock.pull_across(0);
  const GrowthPlan second = rock.plan();
  Mesh refined = rock.geometry.mesh;
  const MeshInsertion refinement = insert_into_mesh(second, refined);
  CHECK(std::binary_search(refinement.change.new_nodes.begin(), refinement.change.new_nodes.end(), lowest));
  CHECK(refined.unused_nodes.empty());
  CHECK(refined.position.size() > refinement.change.nodes_before);
  require_true(refinement.change, rock.geometry.mesh, refined);
  require_sound(refined, rock.model.run_case.domain);
}

TEST_CASE("a junction keeps the unit it parts and lists it as changed", "[structure][fracture]") {
  GrowingRock rock(slit_before_natural_fracture());
  for (int k = 0; k < 8; ++k) {
    rock.pull_across(0);
    const GrowthPlan plan = rock.plan();
    Mesh mesh = rock.geometry.mesh;
    const MeshChange change = insert_into_mesh(plan, mesh).change;
    const auto joins = std::any_of(plan.patches.begin(), plan.patches.end(),
                                   [](const PatchPlan& patch) { return patch.new_vertices.empty(); });
    if (joins) {
      REQUIRE(change.changed_units.size() == 1);
      const UnitIndex unit = change.changed_units[0];
      CHECK(mesh.units[unit].vertex == rock.geometry.mesh.units[unit].vertex);
      CHECK(mesh.units[unit].length < rock.geometry.mesh.units[unit].length);
      return;
    }
    CHECK(change.changed_units.empty());
    rock.insert(plan);
  }
  FAIL("the slit did not reach the fault");
}

TEST_CASE("an element beside the patch gets the node of its side, wherever it is in the list",
          "[structure][fracture]") {
  Case given = slit_before_natural_fracture();
  given.fractures[0].points = {{-3, 0}, {-0.6, 0}};
  GrowingRock rock(given);
  Mesh& mesh = rock.geometry.mesh;
  const FractureTip tip = rock.tip_near({-0.6, 0});
  VertexIndex wall = 0;
  for (VertexIndex v = 0; v < mesh.vertices.size(); ++v)
    if (mesh.vertices[v].position[0] == 0 && std::abs(mesh.vertices[v].position[1]) < 0.01) wall = v;
  const Point end = mesh.vertices[wall].position;
  // A patch so small that it does not hold all the rock around the junction.
  const auto plan_small = [&] {
    const NodeElements node_elements(mesh);
    std::vector<ElementIndex> elements;
    for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
      const auto& corners = mesh.elements[element];
      const Point at = centroid(mesh, element);
      const bool around_tip = std::find(corners.begin(), corners.end(), tip.node) != corners.end();
      if (around_tip || (at[0] < 0 && distance_to_segment(at, tip.position, end) < 0.08))
        elements.push_back(element);
    }
    const PatchOutline around = outline(mesh, elements, fracture_nodes(mesh));
    const auto patch =
        mesh_patch(around, {tip.position, end}, {rock.model.run_case.mesh, tip.position, end}, 0);
    REQUIRE(patch);
    GrowthPlan plan;
    plan.patches = {plan_patch({mesh, node_elements, mesh.vertices.size(), 0},
                               {{tip.position, tip.vertex}, {end, wall}}, elements, around, *patch)};
    return plan;
  };
  const GrowthPlan first = plan_small();
  REQUIRE_FALSE(first.patches[0].rewired.empty());
  Mesh after = mesh;
  require_true(insert_into_mesh(first, after).change, mesh, after);
  require_sound(after, given.domain);

  // The same with that element as the last one of the list, and a second patch that leaves places for it.
  std::swap(mesh.elements[first.patches[0].rewired[0].element], mesh.elements.back());
  rock.geometry.node_elements = NodeElements(mesh);
  GrowthPlan second = plan_small();
  REQUIRE(second.patches[0].rewired[0].element == mesh.elements.size() - 1);
  rock.model.run_case.mesh.tip_size = 0.33;
  const FractureTip west = rock.tip_near({-3, 0});
  const Point beyond{west.position[0] - 0.33, 0};
  const PlannedPlace place = place_segment(rock, west, beyond);
  second.patches.push_back(plan_patch({mesh, rock.geometry.node_elements, mesh.vertices.size(), 0},
                                      {{west.position, west.vertex}, {beyond, std::nullopt}}, place.elements,
                                      place.outline, place.mesh));
  Mesh moved = mesh;
  const MeshInsertion insertion = insert_into_mesh(second, moved);
  require_true(insertion.change, mesh, moved);
  require_sound(moved, given.domain);
  REQUIRE_FALSE(insertion.change.moved.empty());
  CHECK(insertion.change.moved[0].from == mesh.elements.size() - 1);
  CHECK(std::binary_search(insertion.change.rewired.begin(), insertion.change.rewired.end(),
                           insertion.change.moved[0].to));
}
