// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "coupler/report/field_reports.hpp"
#include "coupler/report/view.hpp"

namespace fissura::coupler {

/// Principal effective stresses of single elements at a field report, made to be drawn (numbers rounded to
/// five digits): of each view the element nearest to the middle of each of at most `most_crosses` square
/// cells.
///   {"time" [s], "revision", "views": [{"name", "box": [west, east, south, north] [m],
///    "x", "y" [m], "angle" of the greatest compression [rad from x], "greatest", "least" compression,
///    tension positive [Pa]}]}
/// Throws StorageError.
nlohmann::json stress_crosses(FieldReports& reports, const FieldReport& report,
                              const std::vector<View>& views, int most_crosses);

}  // namespace fissura::coupler
