// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace fissura::coupler {

/// `object` as one line without its end, with the CRC-32 of everything before it as last entry: `crc32`,
/// eight hexadecimal digits. @pre `object` is a JSON object with at least one entry
std::string sealed_line(const nlohmann::ordered_json& object);

/// The object in such a line. Throws StorageError if the line is not as it was written.
nlohmann::json opened_line(std::string_view line);

}  // namespace fissura::coupler
