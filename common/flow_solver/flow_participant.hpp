// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/exchange/participant.hpp"
#include "common/flow_solver/flow_solver.hpp"
#include "common/state_blob.hpp"

namespace fissura {

/// A FlowSolver as the protocol sees it: messages in, checked numbers to the solver, its numbers out
/// (docs/protocol.md, section 3). Keeps the topology, so that the solver need not. Knows no physics.
class FlowParticipant : public Solver {
 public:
  /// `solver` must outlive this. @param name, version  of the program: a state is restored by the same ones
  /// only
  FlowParticipant(FlowSolver& solver, const std::string& name, const std::string& version);

  void introduce(nlohmann::json& hello) const override;
  /// Throws InputError if the case cannot be solved.
  void join(const Assignment& assignment) override;
  /// Throws ProtocolError if the insertion does not fit; nothing has changed then.
  std::string insert(const Insertion& insertion) override;
  /// ADVANCE -> PRESSURE. Throws ProtocolError for arrays that do not fit or an interval that does not follow
  /// the last, ValueError for a negative aperture or compliance, Error(internal) if the solver's answer does
  /// not have one value per node.
  Message advance(const Message& command) override;
  Message report(const Message& command) override;
  std::vector<std::byte> save() override;
  std::optional<std::string> restore(const std::vector<std::byte>& bytes) override;
  void describe_neutral_state(Message& state) override;
  std::optional<std::string> take_up(const Message& command,
                                     const std::vector<Insertion>& insertions) override;
  nlohmann::json finish() override { return solver_.finish(); }

  [[nodiscard]] const FractureNetwork& network() const { return network_; }
  /// Whose state save() gives. @pre join
  [[nodiscard]] const StateOwner& owner() const { return owner_; }

 private:
  [[nodiscard]] CouplingInterval interval_of(const Message& command) const;
  /// One array of the apertures per arm; empty if the command carries neither.
  [[nodiscard]] std::vector<double> arm_apertures(const Message& command, const char* name) const;
  void require_not_negative(const std::vector<double>& values, const char* name) const;

  FlowSolver& solver_;
  StateOwner owner_;
  std::size_t fluids_ = 0;
  std::vector<Insertion> insertions_;
  FractureNetwork network_;
  std::optional<double> time_;  ///< end of the last interval [s]; none before the first
};

}  // namespace fissura
