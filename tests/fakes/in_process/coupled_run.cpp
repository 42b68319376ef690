// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/in_process/coupled_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "common/coupling/interface_compliance.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/scheme/coupling_law.hpp"
#include "coupler/scheme/fracture_extent.hpp"

namespace fissura::fakes {

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

double edge_at_the_tips(const Case& run_case) {
  return run_case.growth.path == PathRule::free ? run_case.mesh.tip_size : run_case.mesh.fracture_size;
}

void forget_wall_times(nlohmann::json& body) {
  if (!body.contains("remeshing")) return;
  for (nlohmann::json& entry : body["remeshing"]) entry.erase("wall_seconds");
}

std::string difference_of_bodies(nlohmann::json a, nlohmann::json b) {
  forget_wall_times(a);
  forget_wall_times(b);
  if (nlohmann::json::to_cbor(a) == nlohmann::json::to_cbor(b)) return {};
  return nlohmann::json::diff(a, b).dump();
}

std::string difference_of_arrays(const Array& a, const Array& b) {
  if (a.name != b.name) return fmt::format("{} in place of {}", b.name, a.name);
  if (a.bytes.size() != b.bytes.size())
    return fmt::format("{} has {} bytes in place of {}", a.name, b.bytes.size(), a.bytes.size());
  const auto [at, other] = std::mismatch(a.bytes.begin(), a.bytes.end(), b.bytes.begin());
  if (at == a.bytes.end()) return {};
  const auto entry = static_cast<std::size_t>(at - a.bytes.begin()) / sizeof(double);
  if (a.dtype != "float64") return fmt::format("{} differs at byte {}", a.name, at - a.bytes.begin());
  double first = 0, second = 0;
  std::memcpy(&first, a.bytes.data() + entry * sizeof(double), sizeof(double));
  std::memcpy(&second, b.bytes.data() + entry * sizeof(double), sizeof(double));
  return fmt::format("{}[{}] is {:.17g} in place of {:.17g}", a.name, entry, second, first);
}

}  // namespace

CoupledRun::CoupledRun(const Case& run_case)
    : case_(run_case),
      clock_(run_case.time.end),
      control_(run_case.coupling, edge_at_the_tips(run_case)),
      events_(pump_events(run_case.injection)) {}

std::vector<Message> CoupledRun::begin(Pair pair) {
  std::vector<Message> answers;
  const Insertion first = pair.structure.first_topology();
  Message& topology = answers.emplace_back(MessageType::topology);
  topology.body["insertion"] = insertion_to_json(first);
  insert(first, pair, answers);
  inlet_ = coupler::find_inlet(network_, case_);
  network_pressure_ = structure_.pressure_applied;
  average_rate_.assign(network_.nodes().size(), 0);
  control_.start(structure_.stable_step);
  return answers;
}

std::vector<Message> CoupledRun::advance(Pair pair) {
  const ClockInterval interval = next_interval();
  const Coupling& coupling = case_.coupling;
  const bool robin = coupling.scheme == CouplingScheme::robin;
  const double bulk_modulus = least_bulk_modulus(case_.fluids);
  std::vector<Message> answers;
  const auto estimate = robin ? coupler::robin_estimate(structure_, compliance_)
                              : coupler::profit_estimate(structure_, network_pressure_, average_rate_,
                                                         coupling.fracture_normal_stiffness);
  answers.push_back(
      stamped(pair.network.advance(coupler::advance_network(interval, network_.revision(), estimate)),
              MessageType::pressure));
  const auto answer = coupler::read_pressure(answers.back(), network_, case_.pressure_range);
  const auto ramps = robin ? coupler::robin_ramps(structure_, answer, compliance_, bulk_modulus)
                           : coupler::profit_ramps(structure_, answer, coupling.fracture_normal_stiffness,
                                                   bulk_modulus, case_.network.minimum_aperture);
  const bool report = report_is_due(interval.end);
  const auto strain_energy = report ? coupler::StrainEnergy::wanted : coupler::StrainEnergy::not_wanted;
  answers.push_back(stamped(
      pair.structure.advance(coupler::advance_structure(interval, network_.revision(), ramps, strain_energy)),
      MessageType::response));
  auto response = coupler::read_response(answers.back(), network_, case_.pressure_range);
  for (std::size_t i = 0; i < response.aperture.size(); ++i)
    average_rate_[i] = (response.aperture[i] - structure_.aperture[i]) / interval.duration();
  network_pressure_ = answer.pressure;
  structure_ = std::move(response);
  clock_.commit(interval);
  control_.observe({interval.end, coupler::drift(network_, structure_, answer), structure_.stable_step,
                    coupler::half_length(network_), inlet_ && structure_.closed[inlet_->node] > 0});
  if (std::binary_search(events_.begin(), events_.end(), interval.end)) control_.reset();
  if (report) {
    ++reports_;
    for (Solver* solver : {&pair.structure, &pair.network})
      answers.push_back(stamped(solver->report(command(MessageType::report)), MessageType::fields));
  }
  const std::optional<Insertion> proposal = structure_.proposal;
  if (proposal) insert(*proposal, pair, answers);
  return answers;
}

ClockInterval CoupledRun::next_interval() const {
  double must_hit = static_cast<double>(reports_ + 1) * case_.output.interval;
  const auto event = std::upper_bound(events_.begin(), events_.end(), clock_.time());
  if (event != events_.end()) must_hit = std::min(must_hit, *event);
  return clock_.next(control_.proposal(), must_hit);
}

bool CoupledRun::report_is_due(double time) const {
  return time >= clock_.end() || time >= static_cast<double>(reports_ + 1) * case_.output.interval;
}

Message CoupledRun::command(MessageType type) const {
  Message message(type);
  message.interval = clock_.index();
  message.revision = network_.revision();
  message.body["time"] = clock_.time();
  return message;
}

// As the participant's side of the exchange does.
Message CoupledRun::stamped(Message answer, MessageType type) const {
  answer.type = type;
  answer.interval = clock_.index();
  answer.revision = network_.revision();
  return answer;
}

void CoupledRun::insert(const Insertion& insertion, Pair pair, std::vector<Message>& answers) {
  network_.apply(insertion);
  Message& of_structure = answers.emplace_back(MessageType::acknowledge);
  // The structure has given revision 0 itself.
  if (insertion.revision > 0) of_structure.body["hash"] = pair.structure.insert(insertion);
  pair.structure.describe_state(of_structure);
  of_structure.revision = network_.revision();
  structure_ = coupler::read_response(of_structure, network_, case_.pressure_range);
  Message& of_network = answers.emplace_back(MessageType::acknowledge);
  of_network.body["hash"] = pair.network.insert(insertion);
  compliance_ =
      interface_compliance(network_, case_.rock.plane_strain_modulus(), case_.coupling.compliance_factor);
  for (std::size_t i = network_pressure_.size(); i < network_.nodes().size(); ++i) {
    const NetworkNode& node = network_.nodes()[i];
    network_pressure_.push_back(node.saturated ? node.formation_pressure : 0);
  }
  average_rate_.resize(network_.nodes().size(), 0);
}

std::optional<std::string> difference(const Message& a, const Message& b) {
  if (a.type != b.type) return fmt::format("{} in place of {}", name(b.type), name(a.type));
  if (const std::string found = difference_of_bodies(a.body, b.body); !found.empty())
    return fmt::format("{}: {}", name(a.type), found);
  if (a.arrays.size() != b.arrays.size())
    return fmt::format("{} has {} arrays in place of {}", name(a.type), b.arrays.size(), a.arrays.size());
  for (std::size_t k = 0; k < a.arrays.size(); ++k)
    if (const std::string found = difference_of_arrays(a.arrays[k], b.arrays[k]); !found.empty())
      return fmt::format("{}: {}", name(a.type), found);
  return std::nullopt;
}

std::optional<std::string> difference(const std::vector<Message>& a, const std::vector<Message>& b) {
  if (a.size() != b.size()) return fmt::format("{} answers in place of {}", b.size(), a.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    if (auto found = difference(a[k], b[k])) return found;
  return std::nullopt;
}

}  // namespace fissura::fakes
