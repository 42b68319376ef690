// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "coupler/seismicity/seismic_event.hpp"

namespace fissura::coupler {

/// Events that are enough to draw a catalogue: all if there are at most `most`, otherwise the half of `most`
/// with the greatest moments and as many of the rest, spread evenly. @returns numbers in rising order
std::vector<std::size_t> events_to_draw(const std::vector<SeismicEvent>& events, std::size_t most);

/// Columns of the events `shown`, one entry each: id, t0, tc, x, y (centroid), M0, Mw (null if none), Mxx,
/// Myy, Mzz, Mxy, iso, clvd, dc, u, v, type, nx, ny, fracture ("open", "natural", "grown", "none"), length,
/// radius, slip, opening, duration. Five digits but for numbers and times.
nlohmann::json event_columns_json(const std::vector<SeismicEvent>& events,
                                  const std::vector<std::size_t>& shown);

}  // namespace fissura::coupler
