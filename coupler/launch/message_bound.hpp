// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "common/case/case.hpp"

namespace fissura::coupler {

/// Bound on the size of one frame from a participant [bytes]; what is larger is no message of this case. The
/// largest are states (STATE) and field reports (FIELDS) of the structure, in proportion to its elements.
/// Their number follows from the target edge length h(x): an equilateral triangle has the area sqrt(3)/4 h^2,
/// so
///   N = integral of dA / (sqrt(3)/4 h^2)
/// over the bands along fractures, both as given and as long as they can grow in the domain, over
/// refinements, over where h grows by `gradation` per length from there, and over the rest at `far_size`.
/// @returns 4 KiB for each element (more than ten times what its state takes), never less than 16 MiB
std::int64_t largest_frame(const Case& run_case);

}  // namespace fissura::coupler
