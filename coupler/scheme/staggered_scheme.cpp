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
#include "coupler/seismicity/moment_tensor.hpp"

namespace fissura::coupler {

namespace {

// The content is updated from the fluxes themselves, so that only rounding may be missing.
constexpr double largest_relative_residual = 1e-10;

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

double edge_at_the_tips(const Case& run_case) {
  return run_case.growth.path == PathRule::free ? run_case.mesh.tip_size : run_case.mesh.fracture_size;
}

}  // namespace

StaggeredScheme::StaggeredScheme(const Case& run_case, double end, Trio& trio, RunRecord& record,
                                 SeismicMonitor& monitor, StatusPage& status)
    : case_(run_case),
      trio_(trio),
      record_(record),
      monitor_(monitor),
      status_(status),
      clock_(end),
      interval_control_(run_case.coupling, edge_at_the_tips(run_case)),
      progress_(end),
      events_(pump_events(run_case.injection)),
      fluid_bulk_modulus_(least_bulk_modulus(run_case.fluids)) {}

SchemeOutcome StaggeredScheme::run() {
  begin();
  while (!clock_.finished() && status_.stop_signal() == 0) {
    const CouplingInterval interval = next_interval();
    const NetworkAnswer answer = advance_network_over(interval);  // the network leads (Sect. 3.1)
    auto response = advance_structure_over(interval, answer);     // the structure follows (Sect. 3.6)
    check_ledger(answer);
    listen(interval, response);  // what broke is heard (Sect. 4)
    record_interval(interval, answer, response);
    accept(interval, answer, std::move(response));
    if (report_is_due(interval.end)) report(answer);
    if (structure_.proposal) insert(*structure_.proposal);  // the fracture grows (Sect. 3.8)
  }
  return {clock_.finished() ? 0 : status_.stop_signal(), insertions_};
}

void StaggeredScheme::begin() {
  status_.show(0, "first topology");
  const Message topology = trio_.await(Role::structure, MessageType::topology);
  const Insertion first = insertion_from_json(topology.value<nlohmann::json>("insertion"));
  insert(first);
  inlet_ = find_inlet(network_, case_);
  network_pressure_ = structure_.pressure_applied;
  average_rate_.assign(network_.nodes().size(), 0);
  interval_control_.start(structure_.stable_step);
}

CouplingInterval StaggeredScheme::next_interval() const {
  double must_hit = static_cast<double>(reports_ + 1) * case_.output.interval;
  for (const double event : events_)
    if (event > clock_.time()) {
      must_hit = std::min(must_hit, event);
      break;
    }
  return clock_.next(interval_control_.proposal(), must_hit);
}

NetworkAnswer StaggeredScheme::advance_network_over(const CouplingInterval& interval) {
  status_.show(interval.index, "network");
  fault_point(FaultPhase::network, interval.index);
  const Coupling& coupling = case_.coupling;
  const StructureEstimate estimate =
      coupling.scheme == CouplingScheme::robin
          ? robin_estimate(structure_, compliance_)
          : profit_estimate(structure_, network_pressure_, average_rate_, coupling.fracture_normal_stiffness);
  const Message answer = trio_.request(
      Role::network, advance_network(interval, network_.revision(), estimate), MessageType::pressure);
  return read_pressure(answer, network_, case_.pressure_range);
}

StructureResponse StaggeredScheme::advance_structure_over(const CouplingInterval& interval,
                                                          const NetworkAnswer& answer) {
  status_.show(interval.index, "structure");
  fault_point(FaultPhase::structure, interval.index);
  const Coupling& coupling = case_.coupling;
  const std::vector<PressureRamp> ramps =
      coupling.scheme == CouplingScheme::robin
          ? robin_ramps(structure_, answer, compliance_, fluid_bulk_modulus_)
          : profit_ramps(structure_, answer, coupling.fracture_normal_stiffness, fluid_bulk_modulus_,
                         case_.network.minimum_aperture);
  const Message response = trio_.request(
      Role::structure,
      advance_structure(interval, network_.revision(), ramps,
                        report_is_due(interval.end) ? StrainEnergy::wanted : StrainEnergy::not_wanted),
      MessageType::response);
  return read_response(response, network_, case_.pressure_range);
}

void StaggeredScheme::check_ledger(const NetworkAnswer& answer) const {
  if (answer.ledger.relative_residual > largest_relative_residual)
    throw SolverError(
        fmt::format("the network lost fluid: its ledger has a relative residual of {:.3g}, allowed is {:.0e}",
                    answer.ledger.relative_residual, largest_relative_residual));
}

void StaggeredScheme::listen(const CouplingInterval& interval, const StructureResponse& response) {
  if (response.sources_merged > 0)
    record_.event(EventLevel::warn, "structure", "sources",
                  fmt::format("{} records of sources went into others: seismicity.maximum_records",
                              response.sources_merged));
  record_.sources(interval.end, response.sources);
  monitor_.listen(interval.end, response.sources);
}

void StaggeredScheme::record_interval(const CouplingInterval& interval, const NetworkAnswer& answer,
                                      const StructureResponse& response) {
  IntervalRecord figures = interval_figures(interval, network_, inlet_, response, answer);
  add_growth_figures(network_, path_, response, case_, figures);
  if (response.strain_energy) strain_energy_ = *response.strain_energy;
  figures.strain_energy = strain_energy_;
  figures.seismicity = monitor_.figures();
  figures.seismicity.transfer_moment = scalar_moment(response.transfer_moment);
  figures.meetings = record_.meeting_totals().met;
  figures.crossings = record_.meeting_totals().crossed;
  record_.interval(figures, response.probes);
  progress_.show(figures);
}

void StaggeredScheme::accept(const CouplingInterval& interval, const NetworkAnswer& answer,
                             StructureResponse&& response) {
  for (std::size_t i = 0; i < response.aperture.size(); ++i)
    average_rate_[i] = (response.aperture[i] - structure_.aperture[i]) / interval.duration();
  network_pressure_ = answer.pressure;
  structure_ = std::move(response);
  clock_.commit(interval);
  interval_control_.observe({interval.end, drift(network_, structure_, answer), structure_.stable_step,
                             half_length(network_), inlet_ && structure_.closed[inlet_->node] > 0});
  if (std::binary_search(events_.begin(), events_.end(), interval.end)) interval_control_.reset();
}

// One message to both: every participant acknowledges with the hash of its own network, or the run ends.
void StaggeredScheme::insert(const Insertion& insertion) {
  status_.show(clock_.index(), "insertion");
  fault_point(FaultPhase::insertion, clock_.index());
  network_.apply(insertion);
  const std::string expected = network_.topology_hash();
  for (const Role role : {Role::structure, Role::network}) {
    Message command(MessageType::insert);
    command.interval = clock_.index();
    command.revision = network_.revision();
    command.body["insertion"] = insertion_to_json(insertion);
    trio_.send(role, std::move(command));
  }
  // While the participants are at it.
  compliance_ =
      interface_compliance(network_, case_.rock.plane_strain_modulus(), case_.coupling.compliance_factor);
  path_ = fracture_path(network_, case_);
  for (const Role role : {Role::structure, Role::network}) {
    const Message acknowledgement = trio_.await(role, MessageType::acknowledge);
    const auto found = acknowledgement.value<std::string>("hash");
    if (found != expected)
      throw ParticipantFailure(
          ExitCode::protocol_violation, role,
          fmt::format("{} has another fracture network after revision {} (hash {:.8}..., expected {:.8}...)",
                      name(role), network_.revision(), found, expected));
    if (role != Role::structure) continue;
    structure_ = read_response(acknowledgement, network_, case_.pressure_range);
    record_.remeshing(network_, read_remeshing(acknowledgement));
    record_.meetings(network_, read_meetings(acknowledgement));
  }
  for (std::size_t i = network_pressure_.size(); i < network_.nodes().size(); ++i) {
    const NetworkNode& node = network_.nodes()[i];
    network_pressure_.push_back(node.saturated ? node.formation_pressure : 0);
  }
  average_rate_.resize(network_.nodes().size(), 0);
  if (network_.revision() > 0) ++insertions_;
  record_.topology(network_);
}

bool StaggeredScheme::report_is_due(double time) const {
  return time >= clock_.end() || time >= static_cast<double>(reports_ + 1) * case_.output.interval;
}

void StaggeredScheme::report(const NetworkAnswer& answer) {
  status_.show(clock_.index(), "report");
  fault_point(FaultPhase::report, clock_.index());
  ++reports_;
  for (const Role role : {Role::structure, Role::network}) {
    Message command(MessageType::report);
    command.interval = clock_.index();
    command.revision = network_.revision();
    command.body["time"] = clock_.time();
    trio_.send(role, std::move(command));
  }
  monitor_.flush();
  const Message structure_fields = trio_.await(Role::structure, MessageType::fields);
  const Message network_fields = trio_.await(Role::network, MessageType::fields);
  record_.fields(clock_.time(), structure_fields, network_fields, network_,
                 {{"pressure_applied", "Pa", structure_.pressure_applied},
                  {"aperture_predicted", "m", answer.aperture_predicted},
                  {"compliance", "m/Pa", compliance_},
                  {"closed", "1", structure_.closed},
                  {"broken", "1", structure_.broken}});
}

}  // namespace fissura::coupler
