// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "coupler/report/field_reports.hpp"

namespace fissura::coupler {

/// The fracture network at up to `most_reports` field reports, numbers rounded for drawing:
///   nodes     {"x", "y"} [m]: every node that ever was, once
///   segments  [[node, node, first entry of `reports` that has it], ...]
///   reports   [{"time" [s], "revision", "aperture" [m], "pressure" [Pa, total]}, ...]: values by node, null
///             for a node not yet there; empty if the flow solver does not give them
/// Throws StorageError.
nlohmann::json fracture_map(FieldReports& reports, std::size_t most_reports);

}  // namespace fissura::coupler
