// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/coupling/coupling_clock.hpp"
#include "common/exchange/participant.hpp"
#include "coupler/scheme/interval_control.hpp"
#include "coupler/scheme/interval_figures.hpp"

/// Structure and network of a case under the laws of the coupler, as calls of functions in one process: what
/// they answer can be held beside what others answer.
namespace fissura::fakes {

/// The two participants of a run.
struct Pair {
  Solver& structure;
  Solver& network;
};

/// What the coupler knows between two intervals; a copy of it drives another pair from there on.
class CoupledRun {
 public:
  /// `run_case` must outlive this.
  explicit CoupledRun(const Case& run_case);

  /// Asks for the first topology and inserts it. The pair has joined. @returns every answer
  std::vector<Message> begin(Pair pair);

  /// One coupling interval with report and insertion where they are due. @returns every answer, in order
  std::vector<Message> advance(Pair pair);

  [[nodiscard]] bool finished() const { return clock_.finished(); }
  [[nodiscard]] std::uint64_t intervals() const { return clock_.index(); }
  [[nodiscard]] double time() const { return clock_.time(); }
  [[nodiscard]] std::uint64_t revision() const { return network_.revision(); }

 private:
  [[nodiscard]] ClockInterval next_interval() const;
  [[nodiscard]] bool report_is_due(double time) const;
  [[nodiscard]] Message stamped(Message answer, MessageType type) const;
  [[nodiscard]] Message command(MessageType type) const;
  void insert(const Insertion& insertion, Pair pair, std::vector<Message>& answers);

  const Case& case_;
  CouplingClock clock_;
  coupler::IntervalControl control_;
  std::vector<double> events_;
  FractureNetwork network_;
  std::vector<double> compliance_, network_pressure_, average_rate_;
  coupler::StructureResponse structure_;
  std::optional<coupler::Inlet> inlet_;
  std::uint64_t reports_ = 0;
};

/// The first thing that is not the same to the last bit in two answers, wall times aside; nothing if all is.
std::optional<std::string> difference(const Message& a, const Message& b);
std::optional<std::string> difference(const std::vector<Message>& a, const std::vector<Message>& b);

}  // namespace fissura::fakes
