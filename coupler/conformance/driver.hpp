// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/flow_solver/flow_solver.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "coupler/conformance/check.hpp"
#include "coupler/solo/driven_participant.hpp"

namespace fissura::coupler::conformance {

/// HELLO.
struct Greeting {
  std::string role, solver, version;
  long pid = 0;
  std::set<std::string> capabilities;
  std::optional<std::set<std::string>> physics;  ///< nothing if it does not say: all of it is assumed
};

/// FIELDS.
struct ReportedFields {
  std::uint64_t geometry = 0;
  std::vector<FlowField> fields;
  /// Values of a field; nothing if the solver does not tell it.
  [[nodiscard]] std::optional<std::vector<double>> find(const std::string& name) const;
};

/// Leads one fresh process of the candidate, as the coupler does, in typed calls. Each call waits for the
/// answer and throws Deviation if it is not what docs/protocol.md demands: another message, another interval
/// or revision, arrays that are missing, in other units, of other lengths or not finite, a topology hash that
/// is not that of the network.
class Driver {
 public:
  /// Starts the process and hears HELLO.
  explicit Driver(const Candidate& candidate);
  /// The same, says WELCOME, and inserts the first topology.
  Driver(const Candidate& candidate, const Case& run_case, const Insertion& first);

  [[nodiscard]] const Greeting& greeting() const { return greeting_; }
  /// The topology as it should be now.
  [[nodiscard]] const FractureNetwork& network() const { return network_; }
  [[nodiscard]] const std::vector<Insertion>& insertions() const { return insertions_; }
  /// Number of the last interval.
  [[nodiscard]] std::uint64_t interval() const { return interval_; }

  void welcome(const Case& run_case);
  /// Takes up a run: WELCOME resuming, RESTORE with `state` after `interval`.
  void resume(const Case& run_case, const std::vector<Insertion>& insertions, std::uint64_t interval,
              const std::vector<std::byte>& state);
  /// The same from a whole STATE, of whatever arrays and body.
  void resume(const Case& run_case, const std::vector<Insertion>& insertions, std::uint64_t interval,
              const Message& state);

  void insert(const Insertion& insertion);
  /// Pressures are at least 0, filled in [0, 1] and 1 where the pressure is positive, predicted apertures at
  /// least 0; the residual is that of the ledger's own entries.
  FlowAnswer advance(const CouplingInterval& interval);
  ReportedFields report();
  /// STATE: the array `state` is in it.
  Message save();
  /// BYE; returns it and waits for the end of the process. @returns `figures`
  nlohmann::json finish();

  // ---- below the typed calls -----------------------------------------------------------------------

  DrivenParticipant& participant() { return participant_; }
  [[nodiscard]] Seconds patience() const { return candidate_.patience; }

  /// The next command, not said; only say it through participant().
  [[nodiscard]] Message welcome_message(const Case& run_case) const;
  [[nodiscard]] Message insert_message(const Insertion& insertion) const;
  [[nodiscard]] Message advance_message(const CouplingInterval& interval) const;
  [[nodiscard]] Message report_message() const;
  [[nodiscard]] Message restore_message(const std::vector<Insertion>& insertions, std::uint64_t interval,
                                        const Message& state) const;
  [[nodiscard]] Message command(MessageType type) const;
  /// What PRESSURE says, checked.
  [[nodiscard]] FlowAnswer answer_of(const Message& pressure) const;

  /// Says `command` and hears its answer, of type `expected` and of the interval and revision of the command.
  Message request(const Message& command, MessageType expected);
  /// Throws Deviation with what was heard, and what the process printed last.
  [[noreturn]] void deviate(const std::string& expected, const Heard& heard) const;

 private:
  void hear_hello();
  void require_hash(const Message& answer) const;

  Candidate candidate_;
  DrivenParticipant participant_;
  Greeting greeting_;
  FractureNetwork network_;
  std::vector<Insertion> insertions_;
  std::uint64_t interval_ = 0;
  double time_ = 0;
};

/// The run in which every candidate takes part.
RunId conformance_run_id();

/// Content m of each node [m] at the end of `interval`, by the law of the interval (flow_solvers.md 3.1):
/// filled * e(p) * (1 + p / K_f). Without joint compliance.
std::vector<double> content_of(const FlowAnswer& answer, double bulk_modulus);

}  // namespace fissura::coupler::conformance
