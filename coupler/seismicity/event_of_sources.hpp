// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "coupler/seismicity/seismic_event.hpp"
#include "coupler/seismicity/source.hpp"

namespace fissura::coupler {

/// shear, tensile, closing or mixed, by the shares of the moment.
EventType event_type(const Decomposition& shares);

/// One event of sources that are linked; its number is still 0. Sums run in the order given. Means over the
/// area count each entity once. A sum below 1e-12 of the scalar sum is rounding: the records cancel.
/// With `equidimensional` moments and area are scaled by length / thickness of the layer.
/// @pre not empty, in their order
SeismicEvent event_of(const std::vector<Source>& sources, const SourceRules& rules,
                      const Geography& geography);

}  // namespace fissura::coupler
