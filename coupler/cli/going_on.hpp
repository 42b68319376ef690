// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "coupler/checkpoint/checkpoint_store.hpp"
#include "coupler/cli/prepared_run.hpp"
#include "coupler/launch/supervisor.hpp"
#include "coupler/launch/trio.hpp"
#include "coupler/record/run_record.hpp"

namespace fissura::coupler {

/// What a checkpoint of `run` is marked with, as far as it is known before the handshake: without the
/// participants.
Provenance provenance_of(const PreparedRun& run);
/// Whole: `trio` has joined.
Provenance provenance_of(const PreparedRun& run, const Trio& trio);

/// From which checkpoint a run goes on, and with which flow solver. In the order of its functions.
class GoingOn {
 public:
  /// All outlive it.
  GoingOn(const PreparedRun& run, const Attempt& attempt, CheckpointStore& store);

  /// The newest checkpoint that is whole, of this case and program, and that the files of the run still go
  /// with; nothing if there has been none, or the attempt does not resume. Warns of every newer one and sets
  /// it aside. Throws Error(checkpoint_unusable) if there are some, but none of use.
  std::optional<Checkpoint> usable_checkpoint();

  /// By the participants that have joined. Throws Error(checkpoint_unusable) if the checkpoint is of others,
  /// and ParticipantFailure(checkpoint_unusable or mismatch) if another flow solver joined that cannot go on.
  void require_usable(const Checkpoint& checkpoint, const Trio& trio);

  /// After require_usable: whether another flow solver goes on than the one that wrote the checkpoint.
  [[nodiscard]] bool with_another_solver() const { return change_.has_value(); }

  /// The participants have taken up the run: from now on it is that of the new flow solver. Says so in the
  /// record, in epochs.jsonl and in the log. Throws StorageError.
  void keep(RunRecord& record) const;

 private:
  [[nodiscard]] std::optional<std::string> refusal(const Checkpoint& checkpoint) const;

  const PreparedRun& run_;
  const Attempt& attempt_;
  CheckpointStore& store_;
  std::optional<NetworkChange> change_;
};

}  // namespace fissura::coupler
