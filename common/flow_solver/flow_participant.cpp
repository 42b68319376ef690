// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/flow_solver/flow_participant.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/flow_solver/flow_messages.hpp"
#include "common/fracture_network/insertion_archive.hpp"

namespace fissura {

namespace {

/// Of what stands around the bytes of a solver.
constexpr std::uint64_t state_format = 4;

Carry carry_named(const std::string& word) {
  if (word == "content") return Carry::content;
  if (word == "pressure") return Carry::pressure;
  throw ProtocolError(fmt::format("carry is \"{}\", expected \"content\" or \"pressure\"", word));
}

}  // namespace

FlowParticipant::FlowParticipant(FlowSolver& solver, const std::string& name, const std::string& version)
    : solver_(solver), owner_{"network", name + " " + version, state_format, {}} {}

void FlowParticipant::introduce(nlohmann::json& hello) const {
  nlohmann::json& capabilities = hello["capabilities"];
  if (solver_.state_kept() == StateKept::none)
    for (const char* word : {"save", "restore"})
      capabilities.erase(std::find(capabilities.begin(), capabilities.end(), word));
  if (solver_.state_kept() == StateKept::own_and_neutral) capabilities.push_back("neutral_state");
  hello["physics"] = solver_.physics();
}

void FlowParticipant::join(const Assignment& assignment) {
  const FlowCase flow = flow_case(assignment.run_case);
  owner_.case_hash = flow.hash;
  fluids_ = flow.fluids.size();
  solver_.join(flow);
}

std::string FlowParticipant::insert(const Insertion& insertion) {
  network_.apply(insertion);
  insertions_.push_back(insertion);
  solver_.insert(insertion, network_);
  return network_.topology_hash();
}

Message FlowParticipant::advance(const Message& command) {
  const CouplingInterval interval = interval_of(command);
  const FlowAnswer answer = solver_.advance(interval);
  require_one_per_node(answer, network_);
  time_ = interval.end;
  return pressure_message(answer);
}

CouplingInterval FlowParticipant::interval_of(const Message& command) const {
  const std::size_t count = network_.nodes().size();
  CouplingInterval interval;
  interval.begin = command.value<double>("begin");
  interval.end = command.value<double>("end");
  if (!(interval.end > interval.begin))
    throw ProtocolError(
        fmt::format("the interval from {} s to {} s has no length", interval.begin, interval.end));
  if (time_ && interval.begin != *time_)
    throw ProtocolError(fmt::format("the interval begins at {} s, expected the end of the last one, {} s",
                                    interval.begin, *time_));
  interval.carry = carry_named(command.value<std::string>("carry"));
  interval.aperture = command.numbers("aperture", count);
  interval.aperture_rate = command.numbers("aperture_rate", count);
  interval.reference_pressure = command.numbers("reference_pressure", count);
  interval.compliance = command.numbers("compliance", count);
  interval.arm_aperture_a = arm_apertures(command, "arm_aperture_a");
  interval.arm_aperture_b = arm_apertures(command, "arm_aperture_b");
  require_not_negative(interval.aperture, "aperture");
  require_not_negative(interval.compliance, "compliance");
  for (const double closed : command.numbers("closed", count)) interval.closed.push_back(closed != 0 ? 1 : 0);
  return interval;
}

void FlowParticipant::require_not_negative(const std::vector<double>& values, const char* name) const {
  const auto found = std::ranges::find_if(values, [](double value) { return value < 0; });
  if (found == values.end()) return;
  const auto node = static_cast<std::size_t>(found - values.begin());
  throw ValueError(
      fmt::format("{} of node {} is {}, expected at least 0", name, network_.nodes()[node].id, *found));
}

std::vector<double> FlowParticipant::arm_apertures(const Message& command, const char* name) const {
  if (!command.has("arm_aperture_a") && !command.has("arm_aperture_b")) return {};
  std::vector<double> values = command.numbers(name, network_.segments().size());
  const auto found = std::ranges::find_if(values, [](double value) { return value < 0; });
  if (found == values.end()) return values;
  const auto segment = static_cast<std::size_t>(found - values.begin());
  throw ValueError(fmt::format("{} of segment {} is {}, expected at least 0", name,
                               network_.segments()[segment].id, *found));
}

Message FlowParticipant::report(const Message&) {
  Message fields(MessageType::fields);
  fields.body["geometry"] = network_.revision();
  for (const FlowField& field : solver_.report()) add_field(field, fields);
  return fields;
}

std::vector<std::byte> FlowParticipant::save() {
  ByteWriter bytes;
  begin_state(owner_, bytes);
  bytes.put(insertions_);
  bytes.put(time_);
  bytes.put(solver_.save());
  return end_state(bytes);
}

std::optional<std::string> FlowParticipant::restore(const std::vector<std::byte>& bytes) {
  ByteReader reader(state_inside(bytes, owner_));
  std::vector<Insertion> insertions;
  std::optional<double> time;
  std::vector<std::byte> state;
  reader.get(insertions);
  reader.get(time);
  reader.get(state);
  reader.end();
  network_ = network_after(insertions);
  solver_.restore(state, network_);
  insertions_ = std::move(insertions);
  time_ = time;
  return network_.topology_hash();
}

void FlowParticipant::describe_neutral_state(Message& state) {
  if (solver_.state_kept() == StateKept::own_and_neutral)
    add_neutral_state(solver_.neutral_state(), fluids_, state);
}

std::optional<std::string> FlowParticipant::take_up(const Message& command,
                                                    const std::vector<Insertion>& insertions) {
  network_ = network_after(insertions);
  const NeutralFlowState state = neutral_state_in(command, network_.nodes().size(), fluids_);
  solver_.take_up(state, network_);
  insertions_ = insertions;
  time_ = state.started ? std::optional(state.time) : std::nullopt;
  return network_.topology_hash();
}

int flow_solver_main(int argc, char** argv, const char* name, const char* version, FlowSolver& solver) {
  FlowParticipant participant(solver, name, version);
  return participant_main(Role::network, argc, argv, name, version, participant);
}

}  // namespace fissura
