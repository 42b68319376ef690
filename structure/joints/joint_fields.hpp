// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "structure/joints/joint_state.hpp"

namespace fissura::structure {

/// Adds the arrays `joint_*` of FIELDS (docs/protocol.md): one row per contact unit, of all fractures.
void add_joint_fields(const Mesh& mesh, const Joints& joints, const FractureNetwork& network,
                      Message& fields);

}  // namespace fissura::structure
