// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/exchange/message.hpp"
#include "common/flow_solver/flow_solver.hpp"

/// The numbers of a flow solver in messages, docs/protocol.md section 3.
namespace fissura {

/// PRESSURE.
Message pressure_message(const FlowAnswer& answer);

/// Throws Error(internal) unless the answer has one pressure, predicted aperture and filled fraction per
/// node.
void require_one_per_node(const FlowAnswer& answer, const FractureNetwork& network);

/// Adds a field to FIELDS.
void add_field(const FlowField& field, Message& fields);

/// Adds the neutral state to STATE or RESTORE. @param fluids  of the case
void add_neutral_state(const NeutralFlowState& state, std::size_t fluids, Message& message);

/// The neutral state in STATE or RESTORE. Throws ProtocolError if an entry is missing or has not one value
/// per node, ValueError if a leaked volume or pressure is negative.
NeutralFlowState neutral_state_in(const Message& message, std::size_t nodes, std::size_t fluids);

}  // namespace fissura
