// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"

namespace fissura::structure::fakes {

/// The shale of Profit et al. (2016) with the wave speeds of its usual density, without in-situ stress and
/// with free sides: what a test of the structure starts from.
Case shale_case();

/// The same under the in-situ stress of the paper's first case, principal axes turned by 40 degrees.
Case stressed_shale_case();

}  // namespace fissura::structure::fakes
