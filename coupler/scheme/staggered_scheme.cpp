// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/staggered_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/coupling/interface_compliance.hpp"
#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/scheme/fracture_extent.hpp"
#include "coupler/scheme/told_by.hpp"
#include "coupler/seismicity/moment_tensor.hpp"

namespace fissura::coupler {

namespace {

std::vector<double> pump_events(const Injection& injection) {
  std::vector<double> events;
  for (const Stage& stage : injection.stages) {
    if (stage.begin > 0) events.push_back(stage.begin);
    if (stage.ramp > 0) events.push_back(stage.begin + stage.ramp);
  }
  std::sort(events.begin(), events.end());
  return events;
}

double least_bulk_modulus(const std::vector<Fluid>& fluids) {
  double least = std::numeric_limits<double>::infinity();
  for (const Fluid& fluid : fluids) least = std::min(least, fluid.bulk_modulus);
  return least;
}

}  // namespace

StaggeredScheme::StaggeredScheme(const Case& run_case, double end, Trio& trio, RunRecord& record,
                                 SeismicMonitor& monitor, Checkpointing& checkpointing, StatusPage& status)
    : case_(run_case),
      trio_(trio),
      record_(record),
      monitor_(monitor),
      checkpointing_(checkpointing),
      status_(status),
      progress_(end),
      events_(pump_events(run_case.injection)),
      fluid_bulk_modulus_(least_bulk_modulus(run_case.fluids)),
      state_(run_case, end) {}

SchemeOutcome StaggeredScheme::run() {
  while (!state_.clock.finished() && status_.stop_signal() == 0) {
    const ClockInterval interval = next_interval();
    const NetworkAnswer answer = advance_network_over(interval);  // the network leads (Sect. 3.1)
    auto response = advance_structure_over(interval, answer);     // the structure follows (Sect. 3.6)
    check_ledger(answer);
    listen(interval, response);  // what broke is heard (Sect. 4)
    record_interval(interval, answer, response);
    accept(interval, answer, std::move(response));
    if (report_is_due(interval.end)) report(answer);
    if (state_.structure.proposal) insert(*state_.structure.proposal);  // the fracture grows (Sect. 3.8)
    if (checkpointing_.is_due(interval.index)) checkpointing_.keep(state_);
  }
  if (state_.clock.finished()) return {0, insertions()};
  if (checkpointing_.is_possible() && !checkpointing_.has_kept(state_.clock.index())) checkpointing_.keep(state_);
  return {status_.stop_signal(), insertions()};
}

void StaggeredScheme::begin() {
  status_.show(0, "first topology");
  const Message topology = trio_.await(Role::structure, MessageType::topology);
  const Insertion first = insertion_from_json(topology.value<nlohmann::json>("insertion"));
  insert(first);
  inlet_ = find_inlet(state_.network, case_);
  state_.network_pressure = state_.structure.pressure_applied;
  state_.average_rate.assign(state_.network.nodes().size(), 0);
  state_.interval_control.start(state_.structure.stable_step);
}

void StaggeredScheme::resume(const Checkpoint& checkpoint, NetworkGoingOn network) {
  restore(checkpoint.states.at("scheme"), state_);
  checkpointing_.give_back(checkpoint, network, state_);
  follow_topology();
  inlet_ = find_inlet(state_.network, case_);
}

ClockInterval StaggeredScheme::next_interval() const {
  double must_hit = static_cast<double>(state_.reports + 1) * case_.output.interval;
  for (const double event : events_)
    if (event > state_.clock.time()) {
      must_hit = std::min(must_hit, event);
      break;
    }
  return state_.clock.next(state_.interval_control.proposal(), must_hit);
}

NetworkAnswer StaggeredScheme::advance_network_over(const ClockInterval& interval) {
  status_.show(interval.index, "network");
  fault_point(FaultPhase::network, interval.index);
  const Coupling& coupling = case_.coupling;
  const StructureEstimate estimate =
      coupling.scheme == CouplingScheme::robin
          ? robin_estimate(state_.structure, compliance_)
          : profit_estimate(state_.structure, state_.network_pressure, state_.average_rate,
                            coupling.fracture_normal_stiffness);
  const Message answer = trio_.request(
      Role::network, advance_network(interval, state_.network.revision(), estimate), MessageType::pressure);
  return told_by(Role::network,
                 [&] { return read_pressure(answer, state_.network, case_.pressure_range); });
}

StructureResponse StaggeredScheme::advance_structure_over(const ClockInterval& interval,
                                                          const NetworkAnswer& answer) {
  status_.show(interval.index, "structure");
  fault_point(FaultPhase::structure, interval.index);
  const Coupling& coupling = case_.coupling;
  const std::vector<PressureRamp> ramps =
      coupling.scheme == CouplingScheme::robin
          ? robin_ramps(state_.structure, answer, compliance_, fluid_bulk_modulus_)
          : profit_ramps(state_.structure, answer, coupling.fracture_normal_stiffness, fluid_bulk_modulus_,
                         case_.network.minimum_aperture);
  const Message response = trio_.request(
      Role::structure,
      advance_structure(interval, state_.network.revision(), ramps,
                        report_is_due(interval.end) ? StrainEnergy::wanted : StrainEnergy::not_wanted),
      MessageType::response);
  return told_by(Role::structure,
                 [&] { return read_response(response, state_.network, case_.pressure_range); });
}

void StaggeredScheme::check_ledger(const NetworkAnswer& answer) const {
  if (answer.ledger.relative_residual > largest_relative_residual)
    throw SolverError(
        fmt::format("the network lost fluid: its ledger has a relative residual of {:.3g}, allowed is {:.0e}",
                    answer.ledger.relative_residual, largest_relative_residual));
}

void StaggeredScheme::listen(const ClockInterval& interval, const StructureResponse& response) {
  if (response.sources_merged > 0)
    record_.event(EventLevel::warn, "structure", "sources",
                  fmt::format("{} records of sources went into others: seismicity.maximum_records",
                              response.sources_merged));
  record_.sources(interval.end, response.sources);
  monitor_.listen(interval.end, response.sources);
}

void StaggeredScheme::record_interval(const ClockInterval& interval, const NetworkAnswer& answer,
                                      const StructureResponse& response) {
  IntervalRecord figures = interval_figures(interval, state_.network, inlet_, response, answer);
  add_growth_figures(state_.network, path_, response, case_, figures);
  if (response.strain_energy) state_.strain_energy = *response.strain_energy;
  figures.strain_energy = state_.strain_energy;
  figures.seismicity = monitor_.figures();
  figures.seismicity.transfer_moment = scalar_moment(response.transfer_moment);
  figures.meetings = record_.meeting_totals().met;
  figures.crossings = record_.meeting_totals().crossed;
  record_.interval(figures, response.probes);
  progress_.show(figures);
  status_.change([&](RunStatus& status) {
    status.time = figures.time;
    status.duration = figures.duration;
    status.drift = figures.drift;
    status.injected = figures.ledger.injected;
    status.in_fractures = figures.ledger.in_fractures;
    status.leaked = figures.ledger.leaked;
    status.ledger_residual = figures.ledger.relative_residual;
    status.insertions = insertions();
  });
}

void StaggeredScheme::accept(const ClockInterval& interval, const NetworkAnswer& answer,
                             StructureResponse&& response) {
  for (std::size_t i = 0; i < response.aperture.size(); ++i)
    state_.average_rate[i] = (response.aperture[i] - state_.structure.aperture[i]) / interval.duration();
  state_.network_pressure = answer.pressure;
  state_.structure = std::move(response);
  state_.clock.commit(interval);
  state_.interval_control.observe({interval.end, drift(state_.network, state_.structure, answer),
                                   state_.structure.stable_step, half_length(state_.network),
                                   inlet_ && state_.structure.closed[inlet_->node] > 0});
  if (std::binary_search(events_.begin(), events_.end(), interval.end)) state_.interval_control.reset();
}

// One message to both: every participant acknowledges with the hash of its own network, or the run ends.
void StaggeredScheme::insert(const Insertion& insertion) {
  status_.show(state_.clock.index(), "insertion");
  fault_point(FaultPhase::insertion, state_.clock.index());
  state_.network.apply(insertion);
  state_.insertions.push_back(insertion);
  const std::string expected = state_.network.topology_hash();
  for (const Role role : {Role::structure, Role::network}) {
    Message command(MessageType::insert);
    command.interval = state_.clock.index();
    command.revision = state_.network.revision();
    command.body["insertion"] = insertion_to_json(insertion);
    trio_.send(role, std::move(command));
  }
  // While the participants are at it.
  follow_topology();
  for (const Role role : {Role::structure, Role::network}) {
    const Message acknowledgement = trio_.await(role, MessageType::acknowledge);
    const auto found = acknowledgement.value<std::string>("hash");
    if (found != expected)
      throw ParticipantFailure(
          ExitCode::protocol_violation, role,
          fmt::format("{} has another fracture network after revision {} (hash {:.8}..., expected {:.8}...)",
                      name(role), state_.network.revision(), found, expected));
    if (role != Role::structure) continue;
    state_.structure =
        told_by(role, [&] { return read_response(acknowledgement, state_.network, case_.pressure_range); });
    record_.remeshing(state_.network, told_by(role, [&] { return read_remeshing(acknowledgement); }));
    record_.meetings(state_.network, told_by(role, [&] { return read_meetings(acknowledgement); }));
  }
  for (std::size_t i = state_.network_pressure.size(); i < state_.network.nodes().size(); ++i) {
    const NetworkNode& node = state_.network.nodes()[i];
    state_.network_pressure.push_back(node.saturated ? node.formation_pressure : 0);
  }
  state_.average_rate.resize(state_.network.nodes().size(), 0);
  record_.topology(state_.network);
}

void StaggeredScheme::follow_topology() {
  compliance_ = interface_compliance(state_.network, case_.rock.plane_strain_modulus(),
                                     case_.coupling.compliance_factor);
  path_ = fracture_path(state_.network, case_);
}

bool StaggeredScheme::report_is_due(double time) const {
  return time >= state_.clock.end() ||
         time >= static_cast<double>(state_.reports + 1) * case_.output.interval;
}

void StaggeredScheme::report(const NetworkAnswer& answer) {
  status_.show(state_.clock.index(), "report");
  fault_point(FaultPhase::report, state_.clock.index());
  ++state_.reports;
  for (const Role role : {Role::structure, Role::network}) {
    Message command(MessageType::report);
    command.interval = state_.clock.index();
    command.revision = state_.network.revision();
    command.body["time"] = state_.clock.time();
    trio_.send(role, std::move(command));
  }
  monitor_.flush();
  const Message structure_fields = trio_.await(Role::structure, MessageType::fields);
  const Message network_fields = trio_.await(Role::network, MessageType::fields);
  record_.fields(state_.clock.time(), structure_fields, network_fields, state_.network,
                 {{"pressure_applied", "Pa", state_.structure.pressure_applied},
                  {"aperture_predicted", "m", answer.aperture_predicted},
                  {"compliance", "m/Pa", compliance_},
                  {"closed", "1", state_.structure.closed},
                  {"broken", "1", state_.structure.broken}});
}

}  // namespace fissura::coupler
