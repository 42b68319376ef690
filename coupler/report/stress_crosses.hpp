// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coupler/report/field_reports.hpp"

namespace fissura::coupler {

/// A rectangle of the plane [m].
struct View {
  std::string name;
  double west = 0, east = 0, south = 0, north = 0;
};

/// The views of a fracture within the domain: "near the tip" that is farthest from the middle of the
/// fracture, "whole fracture" and "whole domain". `nodes` holds x and y of the network's nodes in turn [m];
/// without any there is only the domain.
std::vector<View> views_of(const std::vector<double>& nodes, const View& domain);

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
