// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "coupler/seismicity/catalogue/catalogue_context.hpp"
#include "coupler/seismicity/extraction.hpp"
#include "coupler/seismicity/seismic_event.hpp"

/// catalogue.h5: everything in SI, angles in radians; layout in docs/results.md. Lacking numbers are NaN.
namespace fissura::coupler {

/// Writes `file`.part and publishes it as `file`. Equal arguments give equal bytes. Throws StorageError.
void write_catalogue_hdf5(const std::filesystem::path& file, const std::vector<SeismicEvent>& events,
                          const SeismicSums& sums, const CatalogueContext& context);

/// The events of such a file, every bit as written. Throws StorageError if a column is missing or damaged,
/// InputError if it holds what no event has.
std::vector<SeismicEvent> read_catalogue_hdf5(const std::filesystem::path& file);

}  // namespace fissura::coupler
