// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/exchange/message.hpp"
#include "structure/structure_state.hpp"

namespace fissura::structure {

enum class MeshInReport { included, known };

/// FIELDS of the structure: displacement and velocity of the nodes, effective stress of the elements, their damage and size of plastic strain
/// with bulk failure, the joints, and the mesh itself if the coupler does not have it yet.
Message structure_fields(const StructureModel& model, const Geometry& geometry, const StructureState& state,
                         MeshInReport mesh);

/// Elastic energy of the change from in situ, whole thickness [J].
double strain_energy_of_body(const StructureModel& model, const Geometry& geometry, const StructureState& state);

}  // namespace fissura::structure
