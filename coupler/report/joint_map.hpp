// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "coupler/report/field_reports.hpp"

namespace fissura::coupler {

/// What happened on the natural fractures, at up to `most_reports` field reports:
///   units    {"x", "y" [m], "angle" of the fracture, counter-clockwise from x [rad], "back", "ahead": how
///   far the stroke that stands
///            for it reaches against and along that direction [m]}: every contact unit of a natural fracture
///            on which anything ever happened, once
///   reports  [{"time" [s], "unit": [number in units, ...], "slip": [m, signed], "wetted": [0/1], "open":
///   [0/1]}, ...]: the units on which something has happened,
///            that is slip, opening or wetting
/// Null if the structure reports no contact units. Throws StorageError.
nlohmann::json joint_map(FieldReports& reports, std::size_t most_reports);

}  // namespace fissura::coupler
