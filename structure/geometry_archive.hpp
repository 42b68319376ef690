// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/byte_archive.hpp"
#include "structure/structure_state.hpp"

namespace fissura::structure {

/// The geometry without its network, bit for bit: the mesh with its fractures, and of what is built from it
/// all that depends on the way it came about (the order of sums, the elements of each tile, the shares of the
/// masses, what fluid has changed of the in-situ state).
void save_geometry(const Geometry& geometry, ByteWriter& bytes);

/// The geometry as it was saved. Throws Error(checkpoint_unusable) if the bytes are too few or no geometry
/// could have given them.
Geometry restore_geometry(ByteReader& bytes);

}  // namespace fissura::structure
