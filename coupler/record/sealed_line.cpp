// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/sealed_line.hpp"

#include <fmt/format.h>

#include <span>

#include "common/errors.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

std::string seal_of(std::string_view head) {
  return fmt::format(R"(,"crc32":"{:08x}"}})", crc32(std::as_bytes(std::span(head))));
}

}  // namespace

std::string sealed_line(const nlohmann::ordered_json& object) {
  std::string line = object.dump();
  ENSURE(line.size() > 2 && line.back() == '}');
  line.pop_back();
  return line + seal_of(line);
}

nlohmann::json opened_line(std::string_view line) {
  static const std::size_t seal_size = seal_of("").size();
  if (line.size() > seal_size) {
    const std::string_view head = line.substr(0, line.size() - seal_size);
    if (line.substr(head.size()) == seal_of(head)) {
      try {
        return nlohmann::json::parse(line);
      } catch (const nlohmann::json::exception&) {
      }
    }
  }
  throw StorageError("the line is not what was written: its checksum differs");
}

}  // namespace fissura::coupler
