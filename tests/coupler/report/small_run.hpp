// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"

/// A run directory as the coupler leaves it, small enough to be written down.
namespace fissura::coupler::small_run {

/// The part of an effective case that a report reads: 10 L/s into rock of 20 GPa, in-situ stress of 15 MPa
/// along x and 10 MPa along y.
nlohmann::json effective_case();

/// Two intervals and two field reports, of revision 0 and of the grown revision 1; with `reference`, against
/// a table of its half-length. The summary is not written.
enum class Comparison { none, reference };
void write(const std::filesystem::path& directory, Comparison comparison);

/// Another run of two reports: at the second, the fracture has met a natural one of three contact units, of
/// which one is at rest, at (2, 0) m.
void write_with_natural_fracture(const std::filesystem::path& directory);

/// FIELDS of the structure: two elements under 15 and 10 MPa.
Message structure_fields();
/// FIELDS of the flow solver: aperture i * 0.1 mm and pressure i MPa of the i-th node, from 1.
Message network_fields(const FractureNetwork& network);

}  // namespace fissura::coupler::small_run
