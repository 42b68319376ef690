// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/checkpointing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"
#include "common/flow_solver/flow_messages.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/checkpoint/neutral_network.hpp"
#include "coupler/scheme/told_by.hpp"

namespace fissura::coupler {

namespace {

constexpr std::array both{Role::structure, Role::network};
constexpr PressureRange any_pressure{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};

nlohmann::json insertions_to_json(const std::vector<Insertion>& insertions) {
  nlohmann::json list = nlohmann::json::array();
  for (const Insertion& insertion : insertions) list.push_back(insertion_to_json(insertion));
  return list;
}

Message command(MessageType type, const SchemeState& state) {
  Message message(type);
  message.interval = state.clock.index();
  message.revision = state.network.revision();
  return message;
}

}  // namespace

Checkpointing::Checkpointing(const Case& run_case, Provenance provenance, std::uint32_t epoch,
                             CheckpointStore& store, Trio& trio, RunRecord& record, SeismicMonitor& monitor,
                             StatusPage& status)
    : controls_(run_case.checkpoint),
      fluids_(run_case.fluids.size()),
      provenance_(std::move(provenance)),
      epoch_(epoch),
      store_(store),
      trio_(trio),
      record_(record),
      monitor_(monitor),
      status_(status),
      requests_(status.checkpoints_requested()) {}

bool Checkpointing::is_possible() const {
  return std::all_of(both.begin(), both.end(),
                     [this](Role role) { return trio_.can(role, "save") && trio_.can(role, "restore"); });
}

bool Checkpointing::is_due(std::uint64_t interval) const {
  if (!is_possible()) return false;
  if (status_.checkpoints_requested() != requests_) return true;
  if (controls_.intervals > 0 && interval - last_interval_ >= static_cast<std::uint64_t>(controls_.intervals))
    return true;
  return controls_.interval > 0 &&
         std::chrono::duration<double>(Clock::now() - last_).count() >= controls_.interval;
}

void Checkpointing::keep(const SchemeState& state) {
  const std::uint64_t interval = state.clock.index();
  requests_ = status_.checkpoints_requested();
  status_.show(interval, "checkpoint-prepare");
  for (const Role role : both) trio_.send(role, command(MessageType::save, state));
  // While the participants are at it.
  Checkpoint checkpoint;
  checkpoint.states["scheme"] = save(state);
  checkpoint.states["record"] = record_.save();
  checkpoint.states["seismicity"] = monitor_.save();
  for (const Role role : both) {
    const Message answer = trio_.await(role, MessageType::state);
    checkpoint.states[name(role)] = answer.bytes("state");
    if (role == Role::network && trio_.can(role, "neutral_state"))
      checkpoint.states[neutral_network] = neutral_part(
          told_by(role, [&] { return neutral_state_in(answer, state.network.nodes().size(), fluids_); }));
  }

  status_.show(interval, "checkpoint-commit");
  checkpoint.manifest.provenance = provenance_;
  checkpoint.manifest.epoch = epoch_;
  checkpoint.manifest.interval = interval;
  checkpoint.manifest.time = state.clock.time();
  checkpoint.manifest.revision = state.network.revision();
  checkpoint.manifest.topology_hash = state.network.topology_hash();
  store_.write(std::move(checkpoint));
  last_ = Clock::now();
  last_interval_ = interval;
  kept_any_ = true;
  note_kept(interval, state.clock.time());
}

void Checkpointing::add_state(const Checkpoint& checkpoint, NetworkGoingOn network, const SchemeState& state,
                              Message& restore) const {
  switch (network) {
    case NetworkGoingOn::own_state:
      restore.add_bytes("state", checkpoint.states.at(name(Role::network)));
      return;
    case NetworkGoingOn::neutral_state:
      const NeutralFlowState neutral =
          neutral_state_of(checkpoint.states.at(neutral_network), state.network.nodes().size(), fluids_);
      add_neutral_state(neutral, fluids_, restore);
  }
}

void Checkpointing::give_back(const Checkpoint& checkpoint, NetworkGoingOn network,
                              const SchemeState& state) {
  status_.show(state.clock.index(), "resume");
  fault_point(FaultPhase::resume, state.clock.index());
  for (const Role role : both) {
    Message message = command(MessageType::restore, state);
    message.body["insertions"] = insertions_to_json(state.insertions);
    if (role == Role::network)
      add_state(checkpoint, network, state, message);
    else
      message.add_bytes("state", checkpoint.states.at(name(role)));
    trio_.send(role, std::move(message));
  }
  for (const Role role : both) {
    const Message restored = trio_.await(role, MessageType::restored);
    if (restored.value<std::string>("hash") != state.network.topology_hash())
      throw ParticipantFailure(
          ExitCode::checkpoint_unusable, role,
          fmt::format("{} has another fracture network than the checkpoint", name(role)));
    if (role != Role::structure) continue;
    const std::string differs =
        difference(state.structure, read_response(restored, state.network, any_pressure));
    if (!differs.empty())
      throw ParticipantFailure(
          ExitCode::checkpoint_unusable, role,
          fmt::format("the restored structure has another {} than the checkpoint", differs));
  }
  last_interval_ = state.clock.index();
  kept_any_ = true;
}

void Checkpointing::note_kept(std::uint64_t interval, double time) {
  status_.change([&](RunStatus& status) {
    ++status.checkpoints;
    status.checkpoint_interval = interval;
    status.checkpoint_time = time;
    status.has_checkpoint = true;
  });
  record_.event(EventLevel::info, "coupler", "checkpoint", fmt::format("after interval {}", interval));
}

}  // namespace fissura::coupler
