// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/case/case.hpp"
#include "common/coupling/coupling_clock.hpp"
#include "coupler/launch/status_page.hpp"
#include "coupler/launch/trio.hpp"
#include "coupler/record/run_record.hpp"
#include "coupler/scheme/checkpointing.hpp"
#include "coupler/scheme/coupling_law.hpp"
#include "coupler/scheme/interval_figures.hpp"
#include "coupler/scheme/progress_line.hpp"
#include "coupler/scheme/scheme_state.hpp"
#include "coupler/scheme/seismic_monitor.hpp"

namespace fissura::coupler {

/// How a run of the scheme ended.
struct SchemeOutcome {
  int stop_signal = 0;           ///< of the user, 0 if the run reached its end
  std::uint64_t insertions = 0;  ///< changes of the topology after revision 0
};

/// The network leads, the structure follows: THE LOOP of the coupler.
class StaggeredScheme {
 public:
  /// Runs to `end` [s]. All references must outlive this. The trio has been started.
  StaggeredScheme(const Case& run_case, double end, Trio& trio, RunRecord& record, SeismicMonitor& monitor,
                  Checkpointing& checkpointing, StatusPage& status);

  /// Takes the first topology from the structure. The trio was started afresh.
  void begin();
  /// Takes up the run after `checkpoint`, and gives the participants their states. The trio was started to
  /// resume.
  void resume(const Checkpoint& checkpoint, NetworkGoingOn network);

  /// Runs to the end of the case, or to the coupling time at which somebody wants it to stop; then with a
  /// checkpoint. @pre begun or resumed. Throws ParticipantFailure or another Error at the first fault, with
  /// the record written up to the last complete interval.
  SchemeOutcome run();

 private:
  ClockInterval next_interval() const;
  NetworkAnswer advance_network_over(const ClockInterval& interval);
  StructureResponse advance_structure_over(const ClockInterval& interval, const NetworkAnswer& answer);
  void check_ledger(const NetworkAnswer& answer) const;
  void listen(const ClockInterval& interval, const StructureResponse& response);
  void record_interval(const ClockInterval& interval, const NetworkAnswer& answer,
                       const StructureResponse& response);
  void accept(const ClockInterval& interval, const NetworkAnswer& answer, StructureResponse&& response);
  void insert(const Insertion& insertion);
  void report(const NetworkAnswer& answer);
  void follow_topology();
  [[nodiscard]] bool report_is_due(double time) const;
  [[nodiscard]] std::uint64_t insertions() const { return state_.network.revision(); }

  const Case& case_;
  Trio& trio_;
  RunRecord& record_;
  SeismicMonitor& monitor_;
  Checkpointing& checkpointing_;
  StatusPage& status_;
  ProgressLine progress_;
  std::vector<double> events_;  ///< times at which the pumping changes, ascending [s]
  double fluid_bulk_modulus_;   ///< least of the fluids [Pa]

  SchemeState state_;
  FracturePath path_;               ///< at this revision, as are the next two
  std::vector<double> compliance_;  ///< C_R of each node [m/Pa]
  std::optional<Inlet> inlet_;
};

}  // namespace fissura::coupler
