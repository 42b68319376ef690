// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/structure_snapshot.hpp"

namespace fissura::fuzz {

/// A few dozen elements with a slit and a natural fracture.
Case small_rock_case();
structure::StructureModel small_rock_model();

}  // namespace fissura::fuzz
