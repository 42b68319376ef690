// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "coupler/seismicity/catalogue/catalogue_context.hpp"
#include "coupler/seismicity/seismic_event.hpp"

namespace fissura::coupler {

/// catalogue.xml: the catalogue as QuakeML 1.2 BED; the only door to pugixml. Each event is a "fluid
/// injection" with one centroid (time, place, depth), magnitude Mw, both nodal planes (the one that failed is
/// preferred), principal axes and moment tensor in N m (r up, t south, p east). iso, clvd and doubleCouple
/// are fractions without sign there, as the format has it. What it has no place for stands at the end of each
/// event in our own namespace, named and printed as in catalogue.csv: signed shares, local coordinates,
/// begin, slip, opening, ... An event without magnitude (its records cancel) has no magnitude, planes and
/// axes, but its tensor. Throws Error(precondition) without a georeference, naming the keys that the case
/// needs.
std::string quakeml(const std::vector<SeismicEvent>& events, const CatalogueContext& context);

}  // namespace fissura::coupler
