// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "common/natural_fractures/trace_network.hpp"

namespace fissura {

/// How a trace is changed to fit a network.
struct Fit {
  double aside = 0;           ///< moved to the left of its direction by this [m]
  double begin = 0, end = 0;  ///< new ends, along its axis from its old begin [m]
  double change = 0;          ///< sum of the magnitudes of what its ends and its place are changed by [m]
};

/// The least change that brings a trace into accord with a network and a domain; nothing if none leaves
/// NetworkLimits::shortest of it. `within` is where ends may lie. @pre the trace has a length
std::optional<Fit> fit(const PlanarSegment& trace, const TraceNetwork& network, const Rectangle& within);

/// A trace changed by a fit.
PlanarSegment fitted(const PlanarSegment& trace, const Fit& fit);

}  // namespace fissura
