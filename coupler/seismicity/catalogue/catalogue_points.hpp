// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "coupler/seismicity/catalogue/catalogue_context.hpp"
#include "coupler/seismicity/seismic_event.hpp"

namespace fissura::coupler {

/// catalogue.vtp: the events as points for ParaView (VTK's XML PolyData, version 1.0; values as base64 of
/// little-endian numbers behind a 64-bit count of their bytes). Points are the centroids, z = 0. Every
/// numeric column of the catalogue is an array of its name in SI, NaN where an event has none; words are
/// their numbers. Beside them `moment_tensor`, nine components xx, xy, xz, yx, ...  [N m], and `normal`.
std::string catalogue_points(const std::vector<SeismicEvent>& events, const CatalogueContext& context);

}  // namespace fissura::coupler
