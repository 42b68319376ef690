// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/exchange/participant.hpp"
#include "network/advance.hpp"
#include "network/checkpoint.hpp"
#include "network/graph.hpp"
#include "network/model.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// The flow solver as the coupler sees it: messages in, messages out (docs/protocol.md, section 3). Knows no
/// physics.
class NetworkSolver : public Solver {
 public:
  NetworkSolver();

  /// Throws InputError if the case cannot be solved.
  void join(const Assignment& assignment) override;
  /// Returns the hash of the topology afterwards. Throws ProtocolError if the insertion does not fit.
  std::string insert(const Insertion& insertion) override;
  /// ADVANCE -> PRESSURE. Throws ProtocolError for arrays that do not fit or an interval that does not follow
  /// the last, ValueError for a negative aperture or compliance, SolverError if the flow cannot be solved.
  Message advance(const Message& command) override;
  /// REPORT -> FIELDS: pressure, aperture, filled, content, leaked per node, flux per segment, fluid
  /// fractions.
  Message report(const Message& command) override;
  std::vector<std::byte> save() override;
  void restore(const std::vector<std::byte>& bytes) override;
  /// Seconds at work, Newton iterations, factorisations, steps, halvings.
  nlohmann::json finish() override;

 private:
  void read_interval(const Message& command);
  /// One array of the apertures per arm; empty if the command carries neither.
  [[nodiscard]] std::vector<double> arm_apertures(const Message& command, const char* name) const;
  /// A dry network only keeps the time.
  AdvanceReport pass_dry();
  [[nodiscard]] double predicted_aperture(std::size_t node) const;
  [[nodiscard]] Message pressure_message(const AdvanceReport& report) const;

  Model model_;
  Graph graph_;
  State state_;
  Interval interval_;
  Workspace workspace_;
  std::vector<Insertion> history_;
  StateOwner owner_;
  WorkFigures figures_;  ///< factorisations: those before the last restore
  double seconds_ = 0;   ///< of wall time at work
};

}  // namespace fissura::network
