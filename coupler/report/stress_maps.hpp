// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "coupler/report/field_reports.hpp"
#include "coupler/report/view.hpp"

namespace fissura::coupler {

/// How many pictures, and how fine.
struct MapSize {
  std::size_t most_reports = 1, most_cells = 1;
};

/// The least compressive principal effective stress in `view` [Pa], tension positive, at up to most_reports
/// field reports:
///   {"box": [west, east, south, north] [m], "columns", "rows", "low", "high" [Pa], "reports": [{"time" [s],
///   "values"}, ...]}
/// `values` as raster.hpp's as_bytes() between low and high, which leave out the last two thousandths of the
/// values at either end, because the stress is singular at a tip. Null if no report has the stress. Throws
/// StorageError.
nlohmann::json least_stress_map(FieldReports& reports, const View& view, const MapSize& size);

/// The greatest compressive principal effective stress over the one in situ at the same place, in the same
/// form and without a unit; low and high lie equally far from 1. Null also where the rock is not compressed
/// in situ. With "far": {"distance" [m], "greatest_change"}: the greatest difference from 1 at the last
/// report in cells farther from every node of the network than half of its greater extent; null without a
/// network or such cells.
/// @param in_situ  of the effective case: "stress" [Pa] and "stress_gradient" [Pa/m]
nlohmann::json relative_stress_map(FieldReports& reports, const nlohmann::json& in_situ, const View& view,
                                   const MapSize& size);

/// Whether the structure of this run reports the stress.
bool has_stress(FieldReports& reports, const FieldReport& report);

}  // namespace fissura::coupler
