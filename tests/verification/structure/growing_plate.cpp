// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/structure/growing_plate.hpp"

#include <algorithm>
#include <cmath>

#include "structure/joints/network_topology.hpp"
#include "structure/joints/wet_release.hpp"
#include "structure/structure_snapshot.hpp"
#include "tests/fakes/structure/shale_case.hpp"

namespace fissura::structure {

namespace {

StructureModel pulled(double h, double notch, double stretch, double fracture_energy, std::uint64_t seed) {
  Case given = fakes::shale_case();
  given.domain = {1, 1, 1};
  given.rock.fracture_energy = fracture_energy;
  given.mesh.fracture_size = given.mesh.far_size = given.mesh.corridor = given.mesh.tip_size = h;
  given.mesh.gradation = 0.1;
  given.mesh.seed = seed;
  given.mesh.tip_radius = 4 * h;
  given.mesh.tip_gradation = 0.4;
  given.bulk_failure.active = true;
  given.bulk_failure.softening = Softening::linear;
  given.growth.path = PathRule::free;
  given.growth.tip = TipRule::damage;
  given.growth.nucleation = notch == 0;
  given.boundary.south = {BoundaryKind::displacement, {0, -stretch / 2}, GrowingPlate::end()};
  given.boundary.north = {BoundaryKind::displacement, {0, stretch / 2}, GrowingPlate::end()};
  given.dynamics.initial_mass_scale = given.dynamics.maximum_mass_scale = 1;
  if (notch > 0)
    given.fractures.push_back(
        {.name = "notch", .points = {{-notch, 0}, {notch, 0}}, .friction_coefficient = 0.6, .set = {}});
  return {given, elasticity(given.rock), 1};
}

bool grew(const Mesh& mesh, const FractureEdge& edge) {
  return mesh.lines[edge.line].kind == FractureKind::intact;
}

}  // namespace

GrowingPlate::GrowingPlate(double h, double notch, double stretch, double fracture_energy, std::uint64_t seed)
    : model_(pulled(h, notch, stretch, fracture_energy, seed)),
      geometry_(build_geometry(model_)),
      state_(initial_state(model_, geometry_)),
      tips_(model_) {
  insertions_.push_back(first_insertion(geometry_.mesh, state_.joints, model_.run_case));
  geometry_.network.apply(insertions_.back());
  begin_run();
}

void GrowingPlate::begin_run() {
  run_ = std::make_unique<StructureRun>(model_, geometry_);
  tips_.tend(geometry_, state_);
}

void GrowingPlate::advance() {
  constexpr int steps = 10;
  const double end = time_ + steps * stable_step(model_, geometry_, state_);
  run_->advance(time_, end, state_);
  scale_masses(model_, geometry_, time_, end, state_);
  time_ = end;
  tips_.tend(geometry_, state_);
  state_.sources.tell_quiet(observed_rock(model_, geometry_, state_), state_.joints);
  for (const SourceRecord& record : state_.sources.take(0)) told_ = told_ + record.moment;
  const auto plan = plan_growth(model_, geometry_, state_, time_);
  if (!plan) return;
  tips_.dry(geometry_);
  for (const RemeshRecord& record : grow(*plan, model_, geometry_, state_)) records_.push_back(record);
  for (const NetworkNode& node : plan->insertion.new_nodes)
    release(geometry_.mesh, vertex_of(node.id), state_.joints);
  insertions_.push_back(plan->insertion);
  geometry_.network.apply(plan->insertion);
  begin_run();
}

double GrowingPlate::spent() const {
  return failure_work(model_, geometry_, state_) + cohesive_work(geometry_.mesh, state_.joints);
}

double GrowingPlate::inserted_length() const {
  double length = 0;
  for (const FractureEdge& edge : geometry_.mesh.edges)
    if (grew(geometry_.mesh, edge)) length += edge.length;
  return length;
}

double GrowingPlate::deviation() const {
  double greatest = 0;
  for (const FractureVertex& vertex : geometry_.mesh.vertices)
    greatest = std::max(greatest, std::abs(vertex.position[1]));
  return greatest;
}

void GrowingPlate::restart() {
  const StateOwner owner = structure_owner(model_.run_case);
  StructureHistory history;
  history.insertions = insertions_;
  const std::vector<std::byte> bytes = save_snapshot(owner, history, geometry_, state_, tips_.wet());
  Snapshot snapshot = restore_snapshot(bytes, owner, model_);
  geometry_ = std::move(snapshot.geometry);
  state_ = std::move(snapshot.state);
  tips_.restore(std::move(snapshot.wet));
  run_ = std::make_unique<StructureRun>(model_, geometry_);
}

}  // namespace fissura::structure
