// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#include "common/case/case.hpp"
#include "coupler/checkpoint/checkpoint_store.hpp"
#include "coupler/launch/status_page.hpp"
#include "coupler/launch/trio.hpp"
#include "coupler/record/run_record.hpp"
#include "coupler/scheme/scheme_state.hpp"
#include "coupler/scheme/seismic_monitor.hpp"

namespace fissura::coupler {

/// With what the network goes on: with its own state, or, being another solver than the one before, with that
/// one's neutral state.
enum class NetworkGoingOn { own_state, neutral_state };

/// Keeps what a run needs to go on, and gives it back to the participants: a consistent cut at a coupling
/// time, while nothing is on its way.
class Checkpointing {
 public:
  /// All references must outlive this.
  /// @param provenance  of this run, @param epoch  how often it has been resumed
  Checkpointing(const Case& run_case, Provenance provenance, std::uint32_t epoch,
                CheckpointStore& store, Trio& trio, RunRecord& record, SeismicMonitor& monitor,
                StatusPage& status);

  /// Whether a checkpoint should be kept after coupling interval `interval`: enough time has passed, enough
  /// intervals have, or somebody asked.
  /// Never if a participant cannot save and restore its state.
  [[nodiscard]] bool is_due(std::uint64_t interval) const;

  /// Whether both participants can save and restore their states. @pre the trio has been started
  [[nodiscard]] bool is_possible() const;

  /// Whether the newest checkpoint is that after coupling interval `interval`.
  [[nodiscard]] bool has_kept(std::uint64_t interval) const {
    return kept_any_ && last_interval_ == interval;
  }

  /// Asks the participants for their states and keeps them with those of the coupler, in two phases. Throws
  /// ParticipantFailure and StorageError; the checkpoints before stay.
  void keep(const SchemeState& state);

  /// Gives both participants the states of `checkpoint`. `state` has been restored from it. Throws
  /// ParticipantFailure if one of them has another network afterwards, or the structure another interface;
  /// Error(checkpoint_unusable) if there is no neutral state of this network.
  void give_back(const Checkpoint& checkpoint, NetworkGoingOn network, const SchemeState& state);

 private:
  using Clock = std::chrono::steady_clock;
  void note_kept(std::uint64_t interval, double time);
  void add_state(const Checkpoint& checkpoint, NetworkGoingOn network, const SchemeState& state,
                 Message& restore) const;

  CheckpointControls controls_;
  std::size_t fluids_;
  Provenance provenance_;
  std::uint32_t epoch_;
  CheckpointStore& store_;
  Trio& trio_;
  RunRecord& record_;
  SeismicMonitor& monitor_;
  StatusPage& status_;
  Clock::time_point last_ = Clock::now();
  std::uint64_t last_interval_ = 0;
  bool kept_any_ = false;
  std::uint64_t requests_ = 0;  ///< that have been met
};

}  // namespace fissura::coupler
