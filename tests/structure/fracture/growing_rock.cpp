// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/fracture/growing_rock.hpp"

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "structure/joints/network_topology.hpp"
#include "structure/joints/wet_release.hpp"
#include "tests/fakes/structure/shale_case.hpp"

namespace fissura::structure::fakes {

namespace {

constexpr double pull = 5;  // times the tensile strength

StructureModel model_of(const Case& given) {
  return {given, elasticity(given.rock), 1};
}

Geometry connected(const StructureModel& model) {
  Geometry geometry = build_geometry(model);
  geometry.network.apply(
      first_insertion(geometry.mesh, make_joints(geometry.mesh, model.run_case), model.run_case));
  return geometry;
}

InPlane<double> strain_of(const InPlane<double>& stress, const Rock& rock) {
  const double nu = rock.poissons_ratio, factor = (1 + nu) / rock.youngs_modulus;
  return {factor * ((1 - nu) * stress.xx - nu * stress.yy), factor * ((1 - nu) * stress.yy - nu * stress.xx),
          2 * factor * stress.xy};
}

}  // namespace

Case free_case(double side) {
  Case given = shale_case();
  given.domain = {side, side, 1};
  given.mesh.fracture_size = 0.25;
  given.mesh.far_size = 1;
  given.mesh.corridor = 1.5;
  given.mesh.gradation = 0.4;
  given.mesh.tip_size = 0.25;
  given.mesh.tip_radius = 0.75;
  given.mesh.tip_gradation = 0.4;
  given.growth.path = PathRule::free;
  return given;
}

void add_line(Case& given, const std::string& name, FractureKind kind, Point begin, Point end) {
  FractureLine line;
  line.name = name;
  line.kind = kind;
  line.points = {begin, end};
  line.friction_coefficient = 0.6;
  given.fractures.push_back(line);
}

Case free_slit() {
  Case given = free_case(16);
  add_line(given, "slit", FractureKind::open, {-2.5, 0}, {2.5, 0});
  return given;
}

Case slit_before_natural_fracture() {
  Case given = free_case(16);
  add_line(given, "slit", FractureKind::open, {-3, 0}, {-1, 0});
  add_line(given, "fault", FractureKind::natural, {0, -2}, {0, 2});
  return given;
}

Case slits_on_both_sides() {
  Case given = slit_before_natural_fracture();
  add_line(given, "slit beyond", FractureKind::open, {1, 0}, {3, 0});
  return given;
}

GrowingRock::GrowingRock(const Case& given)
    : model(model_of(given)), geometry(connected(model)), state(initial_state(model, geometry)) {}

void GrowingRock::strain_uniformly(const InPlane<double>& stress) {
  const InPlane<double> strain = strain_of(stress, model.run_case.rock);
  for (std::size_t node = 0; node < geometry.mesh.position.size(); ++node) {
    const Point& at = geometry.mesh.position[node];
    state.body.displacement[2 * node] = strain.xx * at[0] + strain.xy / 2 * at[1];
    state.body.displacement[2 * node + 1] = strain.xy / 2 * at[0] + strain.yy * at[1];
  }
}

void GrowingRock::pull_across(double angle) {
  const double stress = pull * model.run_case.rock.tensile_strength, x = -std::sin(angle),
               y = std::cos(angle);
  strain_uniformly({stress * x * x, stress * y * y, stress * x * y});
}

GrowthPlan GrowingRock::plan() const {
  const std::optional<GrowthPlan> plan = plan_growth(model, geometry, state, 0);
  ENSURE(plan.has_value());
  return *plan;
}

std::vector<RemeshRecord> GrowingRock::insert(const GrowthPlan& plan) {
  const std::vector<RemeshRecord> records = grow(plan, model, geometry, state);
  for (const NetworkNode& node : plan.insertion.new_nodes)
    release(geometry.mesh, vertex_of(node.id), state.joints);
  geometry.network.apply(plan.insertion);
  return records;
}

std::size_t GrowingRock::grow_along(double angle, int times) {
  std::size_t segments = 0;
  for (int k = 0; k < times; ++k) {
    pull_across(angle);
    const std::optional<GrowthPlan> plan = plan_growth(model, geometry, state, 0);
    if (!plan) break;
    segments += insert(*plan).size();
  }
  return segments;
}

FractureTip GrowingRock::tip_near(Point place) const {
  const std::vector<FractureTip> tips = fracture_tips(geometry.mesh);
  ENSURE(!tips.empty());
  return *std::min_element(tips.begin(), tips.end(), [&](const FractureTip& a, const FractureTip& b) {
    return std::hypot(a.position[0] - place[0], a.position[1] - place[1]) <
           std::hypot(b.position[0] - place[0], b.position[1] - place[1]);
  });
}

PlannedPlace place_segment(const GrowingRock& rock, const FractureTip& tip, Point end) {
  const Mesh& mesh = rock.geometry.mesh;
  const PatchChoice choice =
      choose_patch(mesh, rock.geometry.node_elements, rock.model.run_case.mesh,
                   {tip.node, tip.position, end, 2.2 * rock.h()}, CoarseElements::refined);
  PatchOutline around = outline(mesh, choice.elements, fracture_nodes(mesh));
  const std::optional<PatchMesh> patch =
      mesh_patch(around, {tip.position, end}, choice.field, 0.3 * rock.h());
  ENSURE(patch.has_value());
  return {choice.elements, std::move(around), *patch};
}

}  // namespace fissura::structure::fakes
