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
#include "coupler/scheme/coupling_law.hpp"
#include "coupler/scheme/interval_control.hpp"
#include "coupler/scheme/interval_figures.hpp"
#include "coupler/scheme/progress_line.hpp"
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
                  StatusPage& status);

  /// Runs to the end of the case. Throws ParticipantFailure or another Error at the first fault, with the
  /// record written up to the last complete interval.
  SchemeOutcome run();

 private:
  void begin();
  CouplingInterval next_interval() const;
  NetworkAnswer advance_network_over(const CouplingInterval& interval);
  StructureResponse advance_structure_over(const CouplingInterval& interval, const NetworkAnswer& answer);
  void check_ledger(const NetworkAnswer& answer) const;
  void listen(const CouplingInterval& interval, const StructureResponse& response);
  void record_interval(const CouplingInterval& interval, const NetworkAnswer& answer,
                       const StructureResponse& response);
  void accept(const CouplingInterval& interval, const NetworkAnswer& answer, StructureResponse&& response);
  void insert(const Insertion& insertion);
  void report(const NetworkAnswer& answer);
  [[nodiscard]] bool report_is_due(double time) const;

  const Case& case_;
  Trio& trio_;
  RunRecord& record_;
  SeismicMonitor& monitor_;
  StatusPage& status_;
  CouplingClock clock_;
  IntervalControl interval_control_;
  ProgressLine progress_;
  std::vector<double> events_;  ///< times at which the pumping changes, ascending [s]
  double fluid_bulk_modulus_;   ///< least of the fluids [Pa]

  FractureNetwork network_;
  FracturePath path_;                     ///< at this revision
  std::vector<double> compliance_;        ///< C_R of each node at this revision [m/Pa]
  StructureResponse structure_;           ///< at the last coupling time
  std::vector<double> network_pressure_;  ///< of the last interval [Pa]; profit2016 carries it
  std::vector<double> average_rate_;      ///< of the aperture in the last interval [m/s]; profit2016
  std::optional<Inlet> inlet_;
  double strain_energy_ = 0;  ///< at the last report [J]
  std::uint64_t reports_ = 0;
  std::uint64_t insertions_ = 0;
};

}  // namespace fissura::coupler
