// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/case_hash.hpp"

#include <nlohmann/json.hpp>

#include "common/case/case_json.hpp"
#include "common/solver_case_hash.hpp"

namespace fissura {

std::string case_hash(const Case& value) {
  return solver_case_hash(case_to_json(value));
}

}  // namespace fissura
