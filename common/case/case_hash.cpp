// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/case_hash.hpp"

#include <nlohmann/json.hpp>

#include "common/case/case_json.hpp"
#include "common/hash.hpp"

namespace fissura {

std::string case_hash(const Case& value) {
  nlohmann::json json = case_to_json(value);
  for (const char* key : {"title", "time", "output", "georeference", "deadlines", "checkpoint",
                          "pressure_range", "exchange", "participants"})
    json.erase(key);
  const std::string text = json.dump();
  return sha256(std::as_bytes(std::span(text)));
}

}  // namespace fissura
