// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/solver_case_hash.hpp"

#include <nlohmann/json.hpp>

#include "common/hash.hpp"

namespace fissura {

std::string solver_case_hash(nlohmann::json run_case) {
  for (const char* key : {"title", "time", "output", "georeference", "deadlines", "checkpoint",
                          "pressure_range", "exchange", "participants"})
    run_case.erase(key);
  const std::string text = run_case.dump();
  return sha256(std::as_bytes(std::span(text)));
}

}  // namespace fissura
