// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace fissura {

/// A flow solver that is part of Fissura.
struct ShippedFlowSolver {
  std::string_view name;     ///< in `[participants] network` and in `--network`
  std::string_view program;  ///< file beside the coupler
};

inline constexpr std::array shipped_flow_solvers{
    ShippedFlowSolver{"implicit", "network"}, ShippedFlowSolver{"fissura", "network"},
    ShippedFlowSolver{"explicit", "network_explicit"}, ShippedFlowSolver{"uniform", "network_uniform"},
    ShippedFlowSolver{"python", "network_python"}};

/// The program of a name; none for a name that is not among them.
constexpr std::optional<std::string_view> shipped_program(std::string_view name) {
  const auto found = std::find_if(shipped_flow_solvers.begin(), shipped_flow_solvers.end(),
                                  [name](const ShippedFlowSolver& solver) { return solver.name == name; });
  if (found == shipped_flow_solvers.end()) return std::nullopt;
  return found->program;
}

}  // namespace fissura
