// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/going_on.hpp"

#include <fmt/format.h>

#include "common/case/case_json.hpp"
#include "common/log.hpp"
#include "coupler/checkpoint/neutral_network.hpp"
#include "coupler/cli/epochs.hpp"
#include "coupler/cli/run_command.hpp"
#include "coupler/scheme/scheme_state.hpp"
#include "coupler/scheme/seismic_monitor.hpp"

namespace fissura::coupler {

namespace {

std::string solver_of(const Trio& trio, Role role) {
  const ParticipantIdentity& identity = trio.identity(role);
  return identity.solver + " " + identity.version;
}

}  // namespace

Provenance provenance_of(const PreparedRun& run) {
  return {hexadecimal(run.run_id),
          case_hash(case_to_json(run.reading.value)),
          program_version(),
          {},
          run.threads};
}

Provenance provenance_of(const PreparedRun& run, const Trio& trio) {
  Provenance whole = provenance_of(run);
  whole.participants = {{"structure", solver_of(trio, Role::structure)},
                        {"network", solver_of(trio, Role::network)}};
  return whole;
}

GoingOn::GoingOn(const PreparedRun& run, const Attempt& attempt, CheckpointStore& store)
    : run_(run), attempt_(attempt), store_(store) {}

std::optional<Checkpoint> GoingOn::usable_checkpoint() {
  if (!attempt_.resumes) return std::nullopt;
  FoundCheckpoint found =
      store_.newest_usable([this](const Checkpoint& checkpoint) { return refusal(checkpoint); });
  for (const UnusableCheckpoint& unusable : found.unusable)
    log::warn(fmt::format("checkpoint {} cannot be used: {}", unusable.name, unusable.reason));
  if (!found.checkpoint && !found.unusable.empty())
    throw Error(ExitCode::checkpoint_unusable,
                fmt::format("none of the {} checkpoints can be used; of the newest, {}",
                            found.unusable.size(), found.unusable.front().reason));
  store_.set_aside_newer_than(found.checkpoint ? std::optional(found.checkpoint->manifest.interval)
                                               : std::nullopt);
  return std::move(found.checkpoint);
}

/// Why this run cannot go on from a whole checkpoint, as far as that can be told before a participant starts.
std::optional<std::string> GoingOn::refusal(const Checkpoint& checkpoint) const {
  if (const auto other = mismatch(checkpoint.manifest.provenance, provenance_of(run_)))
    return "it is " + *other;
  try {
    SchemeState state(run_.reading.value, run_.end);
    restore(checkpoint.states.at("scheme"), state);
    RunRecord::check(run_.directory, checkpoint.states.at("record"));
    SeismicMonitor::check(run_.directory / catalogue_folder, checkpoint.states.at("seismicity"));
  } catch (const std::out_of_range&) {
    return "a state is missing";
  } catch (const Error& fault) {
    return fault.what();
  }
  return std::nullopt;
}

void GoingOn::require_usable(const Checkpoint& checkpoint, const Trio& trio) {
  if (const auto other = mismatch(checkpoint.manifest.provenance, provenance_of(run_, trio)))
    throw Error(ExitCode::checkpoint_unusable, "the checkpoint cannot be used: it is " + *other);
  change_ = network_change(checkpoint.manifest, solver_of(trio, Role::network), run_.network_since);
  if (!change_) return;
  if (!checkpoint.states.contains(neutral_network))
    throw ParticipantFailure(
        ExitCode::checkpoint_unusable, Role::network,
        fmt::format("{} cannot go on: the checkpoint has no neutral state, because {}, which wrote it, does "
                    "not tell it. Only {} can go on",
                    change_->to, change_->from, change_->from));
  if (!trio.can(Role::network, "neutral_state"))
    throw ParticipantFailure(
        ExitCode::mismatch, Role::network,
        fmt::format("{} cannot go on with what {} computed: it does not claim the capability neutral_state",
                    change_->to, change_->from));
}

void GoingOn::keep(RunRecord& record) const {
  if (attempt_.resumes && run_.network_since == attempt_.epoch) change_network_in_resume_file(run_);
  if (!change_) return;
  const std::string text = fmt::format(
      "after interval {}, at {:.6g} s, {} goes on instead of {}, from the fluid content and the topology",
      change_->interval, change_->time, change_->to, change_->from);
  record.network_changed({{"epoch", attempt_.epoch},
                          {"interval", change_->interval},
                          {"time", change_->time},
                          {"from", change_->from},
                          {"to", change_->to}});
  note_network_change(run_.directory, *change_);
  record.event(EventLevel::info, "network", "another solver", text);
  log::info("another flow solver: " + text);
}

}  // namespace fissura::coupler
