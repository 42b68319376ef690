// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/case/case.hpp"

namespace fissura::structure {

/// Order in which the Hilbert curve through the bounding square of `points` visits them; points in the same
/// finest cell keep their order. Result: indices into `points`. Hilbert, Math. Ann. 38 (1891) 459; quadrant
/// rotation as in Warren, Hacker's Delight, 2nd ed., section 16-2.
std::vector<std::uint32_t> hilbert_order(std::span<const Point> points);

}  // namespace fissura::structure
