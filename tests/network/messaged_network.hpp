// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/flow_solver/flow_participant.hpp"
#include "network/network_solver.hpp"

namespace fissura::network::test {

/// The built-in flow solver behind its messages, without a socket.
class MessagedNetwork : public FlowParticipant {
 public:
  MessagedNetwork() : FlowParticipant(solver_, "fissura", FISSURA_VERSION) {}

 private:
  NetworkSolver solver_;
};

}  // namespace fissura::network::test
