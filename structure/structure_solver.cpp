// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "common/case/case_json.hpp"
#include "common/errors.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "common/log.hpp"
#include "structure/fracture/growth.hpp"
#include "structure/joints/joining_vertices.hpp"
#include "structure/joints/joint_observation.hpp"
#include "structure/joints/natural_figures.hpp"
#include "structure/joints/network_topology.hpp"
#include "structure/joints/wet_release.hpp"
#include "structure/seismicity/merge_records.hpp"
#include "structure/structure_fields.hpp"
#include "structure/structure_snapshot.hpp"

namespace fissura::structure {

namespace {

constexpr double tip_sizes_far_away = 10;  // from which on a slip counts as far from the hydraulic fracture

constexpr double reported_slip = 1e-6;  // before time 0 [m]

constexpr double any_size = std::numeric_limits<double>::infinity();

void require_within(double least, double greatest, const std::vector<double>& values, const char* field,
                    const FractureNetwork& network) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](double value) { return value < least || value > greatest; });
  if (found == values.end()) return;
  const NetworkNode& node = network.nodes()[static_cast<std::size_t>(found - values.begin())];
  throw ValueError(fmt::format("{} of node {} at ({:g}, {:g}) m is {:g}, expected [{:g}, {:g}]", field, node.id,
                               node.x, node.y, *found, least, greatest));
}

}  // namespace

void StructureSolver::join(const Assignment& assignment) {
  const auto start = std::chrono::steady_clock::now();
  Case run_case = case_from_json(assignment.run_case);
  const Elasticity moduli = elasticity(run_case.rock);
  model_.emplace(StructureModel{std::move(run_case), moduli, assignment.threads});
  owner_ = structure_owner(model_->run_case);
  probes_.emplace(model_->run_case.output.probes);
  if (model_->run_case.bulk_failure.active && model_->run_case.growth.tip == TipRule::damage)
    failing_tips_.emplace(*model_);
  if (!assignment.resumes) build();
  setup_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void StructureSolver::build() {
  geometry_ = build_geometry(*model_);
  state_.emplace(initial_state(*model_, geometry_));
  run_ = std::make_unique<StructureRun>(*model_, geometry_);
  begin_motion();
  protect_tips();
  log::info(
      fmt::format("{} elements, {} nodes", geometry_.mesh.elements.size(), geometry_.mesh.position.size()));
}

void StructureSolver::begin_motion() {
  Equilibration& rest = history_.equilibration;
  if (model_->run_case.dynamics.equilibrate) rest = come_to_rest(*model_, geometry_, *state_);
  start_motion(*model_, geometry_, *state_);
  if (rest.greatest_slip > reported_slip)
    log::info(fmt::format(
        "before time 0 natural fracture '{}' slid by {:.3g} m until it rested; slip counts from there",
        rest.fracture, rest.greatest_slip));
}

Insertion StructureSolver::first_topology() {
  const Insertion first = first_insertion(geometry_.mesh, state_->joints, model_->run_case);
  geometry_.network.apply(first);
  history_.insertions.push_back(first);
  return first;
}

void StructureSolver::describe_state(Message& reply) {
  const JointObservation seen = observe_joints(geometry_.mesh, state_->joints, geometry_.network);
  reply.add("aperture", "m", seen.aperture);
  reply.add("aperture_rate", "m/s", seen.aperture_rate);
  reply.add("pressure_applied", "Pa", seen.pressure_applied);
  reply.add("pressure_opening", "Pa", seen.pressure_opening);
  reply.add("closed", "1", seen.closed);
  reply.add("broken", "1", seen.broken);
  reply.add("arm_aperture_a", "m", seen.arm_aperture_a);
  reply.add("arm_aperture_b", "m", seen.arm_aperture_b);
  reply.body["stable_step"] = stable_step(*model_, geometry_, *state_);
  reply.body["mass_scale"] = state_->mass_scaling.scale();
  reply.body["elements"] = geometry_.mesh.elements.size();
  if (!remeshing_.empty()) reply.body["remeshing"] = remeshing_json(remeshing_);
  if (!meetings_.empty()) reply.body["meetings"] = meetings_json(meetings_);
  remeshing_.clear();
  meetings_.clear();
}

Message StructureSolver::advance(const Message& command) {
  const double begin = command.value<double>("begin"), end = command.value<double>("end");
  if (begin != history_.time || !(end > begin))
    throw ProtocolError(
        fmt::format("ADVANCE from {} to {} s, the structure is at {} s", begin, end, history_.time));
  set_ramps_of(command);
  const std::uint64_t steps = run_->advance(begin, end, *state_);
  history_.time = end;
  history_.steps += steps;
  scale_masses(*model_, geometry_, begin, end, *state_);
  if (failing_tips_) failing_tips_->tend(geometry_, *state_);

  Message response(MessageType::response);
  describe_state(response);
  response.body["steps"] = steps;
  const double thickness = model_->run_case.domain.thickness;
  response.body["energy"]["kinetic"] = thickness * run_->kinetic_energy();
  response.body["energy"]["cohesive"] = thickness * cohesive_work(geometry_.mesh, state_->joints);
  response.body["energy"]["failure"] = thickness * failure_work(*model_, geometry_, *state_);
  if (has_natural_fractures(geometry_.mesh)) response.body["natural_fractures"] = natural_fractures_json();
  if (probes_->any())
    response.body["probes"] = probes_json(probes_->observe(*model_, geometry_, *state_), state_->joints);
  if (command.value<bool>("strain_energy"))
    response.body["energy"]["strain"] = strain_energy_of_body(*model_, geometry_, *state_);
  const std::optional<Insertion> proposal = propose_growth();
  insertion_is_due_ = proposal.has_value();
  if (proposal) response.body["insertion"] = insertion_to_json(*proposal);
  if (state_->sources.active()) tell_sources(command, response);
  return response;
}

std::string StructureSolver::insert(const Insertion& insertion) {
  if (growth_) {
    if (insertion != growth_->insertion)
      throw ProtocolError(fmt::format("INSERT of revision {} is not the growth that the structure proposed",
                                      insertion.revision));
    if (failing_tips_) failing_tips_->dry(geometry_);
    meetings_ = growth_->meetings;
    remeshing_ = grow(*growth_, *model_, geometry_, *state_);
    growth_.reset();
    renew_run();
    protect_tips();
  }
  for (const NetworkNode& node : insertion.new_nodes) {
    const VertexIndex vertex = vertex_of(node.id);
    if (vertex >= geometry_.mesh.vertices.size() || geometry_.mesh.vertices[vertex].units.empty())
      throw ProtocolError(fmt::format("INSERT connects node {}, which is no fracture vertex", node.id));
    release(geometry_.mesh, vertex, state_->joints);
  }
  geometry_.network.apply(insertion);
  history_.insertions.push_back(insertion);
  insertion_is_due_ = false;
  return geometry_.network.topology_hash();
}

Message StructureSolver::report(const Message&) {
  const bool known = history_.reported_geometry == geometry_.number;
  history_.reported_geometry = geometry_.number;
  return structure_fields(*model_, geometry_, *state_, known ? MeshInReport::known : MeshInReport::included);
}

std::vector<std::byte> StructureSolver::save() {
  if (insertion_is_due_)
    throw ProtocolError("SAVE came between a proposed insertion and its INSERT: the state is not whole then");
  return save_snapshot(owner_, history_, geometry_, *state_, failing_tips_ ? failing_tips_->wet() : std::vector<ElementIndex>{});
}

std::optional<std::string> StructureSolver::restore(const std::vector<std::byte>& bytes) {
  Snapshot snapshot = restore_snapshot(bytes, owner_, *model_);
  history_ = std::move(snapshot.history);
  geometry_ = std::move(snapshot.geometry);
  state_.emplace(std::move(snapshot.state));
  if (failing_tips_) failing_tips_->restore(std::move(snapshot.wet));
  probes_.emplace(model_->run_case.output.probes);
  insertion_is_due_ = false;
  growth_.reset();
  meetings_.clear();
  remeshing_.clear();
  renew_run();
  return geometry_.network.topology_hash();
}

nlohmann::json StructureSolver::finish() {
  const LoopTimes times = loop_times();
  return {{"elements", geometry_.mesh.elements.size()},
          {"nodes", geometry_.mesh.position.size()},
          {"explicit_steps", history_.steps},
          {"equilibration_steps", history_.equilibration.steps},
          {"equilibration_slip", history_.equilibration.greatest_slip},
          {"setup_seconds", setup_seconds_},
          {"element_seconds", times.elements},
          {"joint_seconds", times.joints}};
}

nlohmann::json StructureSolver::natural_fractures_json() const {
  const double far = tip_sizes_far_away * model_->run_case.mesh.tip_size;
  const NaturalFigures figures = natural_figures(geometry_.mesh, state_->joints, geometry_.network, far);
  return {{"greatest_slip", figures.greatest_slip}, {"slipped_length", figures.slipped_length},
          {"opened_length", figures.opened_length}, {"wetted_length", figures.wetted_length},
          {"slip_distance", figures.slip_distance}, {"greatest_far_slip", figures.greatest_far_slip}};
}

void StructureSolver::set_ramps_of(const Message& command) {
  const std::size_t nodes = geometry_.network.nodes().size();
  const auto pressure_begin = command.numbers("pressure_begin", nodes),
             pressure_end = command.numbers("pressure_end", nodes);
  const auto aperture_begin = command.numbers("aperture_begin", nodes),
             aperture_end = command.numbers("aperture_end", nodes);
  const auto stiffness = command.numbers("stiffness", nodes);
  const PressureRange& pressure = model_->run_case.pressure_range;
  require_within(pressure.minimum, pressure.maximum, pressure_begin, "pressure_begin", geometry_.network);
  require_within(pressure.minimum, pressure.maximum, pressure_end, "pressure_end", geometry_.network);
  require_within(0, any_size, aperture_begin, "aperture_begin", geometry_.network);
  require_within(0, any_size, aperture_end, "aperture_end", geometry_.network);
  require_within(0, any_size, stiffness, "stiffness", geometry_.network);
  std::vector<PressureRamp> ramps;
  for (std::size_t i = 0; i < nodes; ++i)
    ramps.push_back({pressure_begin[i], pressure_end[i], aperture_begin[i], aperture_end[i], stiffness[i]});
  set_ramps(geometry_.mesh, geometry_.network, ramps, state_->joints);
}

void StructureSolver::tell_sources(const Message& command, Message& response) {
  const ObservedRock rock = observed_rock(*model_, geometry_, *state_);
  if (command.value<bool>("strain_energy"))
    state_->sources.tell_quiet(rock, state_->joints);
  else if (growth_)
    state_->sources.tell_quiet(rock, state_->joints, entities_that_change(*growth_));
  SourceRecords told = merged(state_->sources.take(command.interval),
                              static_cast<std::size_t>(model_->run_case.seismicity.maximum_records));
  for (Array& array : arrays_of(told.records)) response.arrays.push_back(std::move(array));
  response.body["sources_merged"] = told.merged;
  response.body["transfer_moment"] = state_->sources.transferred();
}

std::optional<Insertion> StructureSolver::propose_growth() {
  if (model_->run_case.growth.path == PathRule::free) {
    growth_ = plan_growth(*model_, geometry_, *state_, history_.time);
    if (growth_) return growth_->insertion;
  }
  const std::vector<VertexIndex> vertices =
      joining_vertices(geometry_.mesh, state_->joints, geometry_.network,
                       {vertices_to_release(geometry_.mesh, state_->joints, geometry_.network), {}});
  if (vertices.empty()) return std::nullopt;
  return connect(geometry_.mesh, geometry_.network, vertices, model_->run_case, history_.time);
}

void StructureSolver::renew_run() {
  earlier_loops_ = loop_times();
  run_ = std::make_unique<StructureRun>(*model_, geometry_);
}

void StructureSolver::protect_tips() {
  if (failing_tips_)
    failing_tips_->tend(geometry_, *state_);
  else if (model_->run_case.bulk_failure.active && model_->run_case.growth.path == PathRule::free)
    forbid_onset(geometry_.tiles, tip_surroundings(*model_, geometry_, state_->joints), state_->body.damage);
}

LoopTimes StructureSolver::loop_times() const {
  LoopTimes times = run_ ? run_->loop_times() : LoopTimes{};
  times.elements += earlier_loops_.elements;
  times.joints += earlier_loops_.joints;
  return times;
}

}  // namespace fissura::structure
