// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "common/natural_fractures/clean_traces.hpp"
#include "common/natural_fractures/set_statistics.hpp"

namespace fissura {

/// How the natural fractures of a case came about.
struct NaturalFractureReport {
  std::vector<SetStatistics> sets;       ///< of Case::natural_fracture_sets, in order
  std::vector<CleaningRecord> cleaning;  ///< every change, in order of the traces
  std::size_t given = 0, drawn = 0;      ///< traces before cleaning: given one by one, and drawn from sets
  std::size_t kept = 0;                  ///< after
  double length = 0;                     ///< of all that are kept [m]
};

/// Draws the sets of a case, cleans the traces together with those given one by one (which come first and so
/// keep their places before others), and appends what is left to Case::fractures. `given` are lines of kind
/// natural with two points each. @pre the case is free of faults
NaturalFractureReport add_natural_fractures(Case& to, std::span<const FractureLine> given);

}  // namespace fissura
