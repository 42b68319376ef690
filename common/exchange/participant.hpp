// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "common/errors.hpp"
#include "common/exchange/curve_keys.hpp"
#include "common/exchange/message.hpp"
#include "common/exchange/role.hpp"
#include "common/fracture_network/fracture_network.hpp"

/// The participant's side of docs/protocol.md: one solver of the trio, driven by the coupler.
namespace fissura {

/// What WELCOME gives a participant.
struct Assignment {
  nlohmann::json run_case;  ///< the case in SI, see common/case/case_json.hpp
  int threads = 1;
  /// A restore follows: nothing that the restored state replaces need be computed, and no topology is asked
  /// for.
  bool resumes = false;
};

/// A solver as the coupler sees it. Calls come in this order: join; insert (revision 0), or, of an Assignment
/// that resumes, restore; then any number of advance, insert, report, save; finish. Any of them may throw:
/// the failure is sent to the coupler and the process ends with the code of the Error.
class Solver {
 public:
  virtual ~Solver() = default;

  /// What HELLO says besides who this is: may add to its `capabilities`, and other keys.
  virtual void introduce(nlohmann::json& hello) const { (void)hello; }

  /// Builds the solver from the case. A structure returns the Insertion of revision 0 as TOPOLOGY; a network
  /// returns nothing of interest.
  virtual void join(const Assignment& assignment) = 0;
  /// Structure only: revision 0 of the fracture network, asked for once, after join.
  virtual Insertion first_topology() { throw ProtocolError("this participant has no topology to give"); }
  /// Values that go with TOPOLOGY or an ACKNOWLEDGE (structure: aperture and so on of every node).
  virtual void describe_state(Message& reply) { (void)reply; }
  /// One coupling interval: ADVANCE in, PRESSURE (network) or RESPONSE (structure) out.
  virtual Message advance(const Message& command) = 0;
  /// A change of topology; the solver returns the hash of its own copy of the network afterwards.
  virtual std::string insert(const Insertion& insertion) = 0;
  /// Fields for the record: REPORT in, FIELDS out.
  virtual Message report(const Message& command) = 0;
  /// Everything that later answers depend on, bit for bit, as an opaque blob: at a coupling time, with no
  /// insertion proposed that has not been carried out. restore gives it back to another process of the same
  /// program and case, and returns the hash of the solver's own copy of the network, nothing if it keeps none; throws
  /// Error(checkpoint_unusable) if the bytes are none of its own, and is unchanged then.
  virtual std::vector<std::byte> save() = 0;
  virtual std::optional<std::string> restore(const std::vector<std::byte>& state) = 0;
  /// Adds to STATE what another program can go on from; without it only the blob is kept.
  virtual void describe_neutral_state(Message& state) { (void)state; }
  /// RESTORE without a blob: goes on from what another program's describe_neutral_state gave. Returns the hash as
  /// restore does.
  virtual std::optional<std::string> take_up(const Message& command, const std::vector<Insertion>& insertions) {
    (void)command;
    (void)insertions;
    throw Error(ExitCode::checkpoint_unusable, "this participant cannot go on from another one's state");
  }
  /// Last figures of the participant for summary.json (wall times, counts).
  virtual nlohmann::json finish() { return nlohmann::json::object(); }
};

/// How a participant process was started (see parse_participant_arguments).
struct ParticipantOptions {
  std::string endpoint;
  std::string solver_name, solver_version;
  double coupler_deadline = 60;  ///< wall seconds without any word from the coupler [s]
  std::optional<ParticipantKeys> keys = {};
};

/// Tells the coupler that the solver is still getting on, at most ten times a second; cheap enough for every
/// explicit step and every Newton iteration. Does nothing outside run_participant.
void note_progress(const char* phase);

/// Connects, joins, serves the coupler's commands until FINISH and returns the exit code of the process.
/// Every failure is sent as FAIL with a sentence, and printed, before it returns. Ends with a sentence of its
/// own if the coupler disappears (connection lost) or is silent for longer than coupler_deadline.
int run_participant(Role role, const ParticipantOptions& options, Solver& solver);

/// The whole main() of a participant: reads `--connect ENDPOINT` and `--keys DIR`, runs, and turns exceptions
/// into exit codes.
int participant_main(Role role, int argc, char** argv, const char* solver_name, const char* solver_version,
                     Solver& solver);

}  // namespace fissura
