// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/natural_fractures/planar_segment.hpp"
#include "common/natural_fractures/trace_network.hpp"

namespace fissura {

/// A straight natural fracture.
struct Trace {
  std::string set;  ///< empty if it was given by itself
  std::string name;
  PlanarSegment segment;
};

enum class CleaningAction {
  kept_inside,  ///< cut where it comes near a side of the domain
  shortened,
  extended,  ///< to end on another line
  moved,     ///< aside, along its normal
  removed
};

/// "shortened" and so on, as written in results.
std::string name(CleaningAction action);

/// One change that cleaning made.
struct CleaningRecord {
  std::string set, trace;
  CleaningAction action = CleaningAction::removed;
  Point
      at{};  ///< where [m]: the end that changed, as it was; the middle of a trace that was moved or removed
  double amount = 0;  ///< length cut off, added, moved by or removed [m]
  std::string cause;  ///< a phrase, naming the line in the way
};

struct CleanedTraces {
  std::vector<Trace> traces;  ///< those that are left, in order
  std::vector<CleaningRecord> records;
};

/// Makes traces meshable together with the other lines of a case, which stay as they are (lines of kind
/// intact only if fractures follow them). Traces are taken up one after the other; each is brought into
/// accord with those before it by the least change of its ends along its own axis (cut, or lengthened by at
/// most one natural_size to end on a line) and of its place across it (by at most one natural_size, and never
/// to get away from a line it lies on or meets at less than NetworkLimits::angle), and removed if less than
/// NetworkLimits::shortest would be left. Hence the result keeps NetworkLimits, and cleaning it again changes
/// nothing.
CleanedTraces clean_traces(std::vector<Trace> traces, const Case& given);

}  // namespace fissura
