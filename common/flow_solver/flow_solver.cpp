// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/flow_solver/flow_solver.hpp"

#include "common/errors.hpp"

namespace fissura {

namespace {

[[noreturn]] void not_there(const char* what) {
  throw Error(ExitCode::internal, std::string("this flow solver has no ") + what);
}

}  // namespace

std::vector<std::byte> FlowSolver::save() const {
  not_there("state to save");
}

void FlowSolver::restore(std::span<const std::byte>, const FractureNetwork&) {
  not_there("state to restore");
}

NeutralFlowState FlowSolver::neutral_state() const {
  not_there("neutral state");
}

void FlowSolver::take_up(const NeutralFlowState&, const FractureNetwork&) {
  not_there("way to take up a neutral state");
}

}  // namespace fissura
