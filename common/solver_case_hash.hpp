// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace fissura {

/// SHA-256 of all of a case (as participants receive it) that the state of a solver depends on: not of its
/// title, its end, its output, or how the programs are watched and reached, which may be others when a run is
/// resumed.
std::string solver_case_hash(nlohmann::json run_case);

}  // namespace fissura
