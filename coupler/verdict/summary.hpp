// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "common/errors.hpp"
#include "coupler/record/history.hpp"
#include "coupler/record/meetings.hpp"
#include "coupler/record/remesh_ledger.hpp"
#include "coupler/verdict/verdict.hpp"

namespace fissura::coupler {

/// Where the wall time went [s].
struct WallTimes {
  double total = 0;       ///< from the start of the coupler's work to its end
  double structure = 0;   ///< the structure at work
  double element = 0;     ///< of `structure`: element loop with the nodes it moves
  double joint = 0;       ///< of `structure`: joint loop with its nodes
  double network = 0;     ///< the network at work
  double coupler = 0;     ///< the coupler at work
  double seismicity = 0;  ///< of `coupler`: events and their catalogue
  double waiting = 0;     ///< of all three at once: messages on their way
};

/// What ended a run before its time.
struct Failure {
  ExitCode code = ExitCode::internal;
  std::string participant;  ///< "coupler", "structure" or "network"
  std::uint64_t interval = 0;
  std::string phase;
  std::string sentence;
};

/// Figures of a run that its history does not hold.
struct RunFigures {
  WallTimes wall;
  std::uint64_t elements = 0, nodes = 0;  ///< of the structure's last mesh
  std::uint64_t insertions = 0;           ///< changes of the topology after revision 0
  RemeshTotals remeshing;
  MeetingTotals meetings;
  nlohmann::ordered_json seismicity;  ///< what the catalogue holds; null without one
  double slip_before_time_0 = 0;      ///< greatest one that natural fractures needed to come to rest [m]
  std::optional<Failure> failure;
};

/// The content of summary.json (docs/results.md). Scripts rely on its keys. `verdict` is "fail" after a
/// failure, whatever the quantities say.
nlohmann::ordered_json summary_json(const Verdict& verdict, const History& history,
                                    const RunFigures& figures);

}  // namespace fissura::coupler
