// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/mesh/mesh.hpp"

namespace fissura::structure {

/// The mesh of a case: the domain triangulated with the fracture lines as edges (planar_mesh.hpp), cut along
/// them (split_fractures.hpp) and put in memory order (order.hpp). Lines of kind intact are left out where
/// fractures grow freely. The same case gives the same bits. Throws InputError, naming lines and coordinates,
/// if the lines cannot be meshed (line_arrangement.hpp), and SolverError if the triangulation fails or has an
/// element without area.
Mesh build_mesh(const Case& run_case);

}  // namespace fissura::structure
