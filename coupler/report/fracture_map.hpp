// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "coupler/report/field_reports.hpp"

namespace fissura::coupler {

/// The fracture network at up to `most_reports` field reports, numbers rounded for drawing:
///   nodes     {"x", "y"} [m]: every node that ever was, once
///   segments  [[node, node, first entry of `reports` that has it], ...]
///   kinds     of the segments: 0 hydraulic, 1 natural
///   reports   [{"time" [s], "revision", "aperture" [m], "pressure" [Pa, total]}, ...]: values by node, null
///             for a node not yet there; empty if the flow solver does not give them
/// Throws StorageError.
nlohmann::json fracture_map(FieldReports& reports, std::size_t most_reports);

/// x and y [m] of the ends of all hydraulic segments of a topology revision in turn; those of neighbours come
/// twice. Throws StorageError.
std::vector<double> hydraulic_nodes(FieldReports& reports, std::uint64_t revision);

}  // namespace fissura::coupler
