// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "coupler/seismicity/catalogue/catalogue_context.hpp"
#include "coupler/seismicity/seismic_event.hpp"
#include "tests/coupler/temporary_directory.hpp"

namespace fissura::coupler::sample {

/// Every member random, over the whole range of sizes and signs that it can have; nothing fits together.
/// Every seventh has no magnitude; among them are zeros of both signs and the smallest and greatest numbers.
std::vector<SeismicEvent> random_events(std::size_t count, std::uint32_t seed);

/// Whether every member has the same bits; a zero differs from its negative.
bool same_bits(const SeismicEvent& a, const SeismicEvent& b);

/// A case in shale, whose y axis points 30 degrees east of north, with a georeference.
Case placed_case();
CatalogueContext placed_context();
CatalogueContext context_without_place();

/// Sources of `count` events far apart in space: slip and opening of faces in all directions.
std::vector<SourceRecord> random_sources(std::size_t count, std::uint32_t seed);

}  // namespace fissura::coupler::sample
