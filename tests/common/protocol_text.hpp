// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fissura::test {

/// The tables of protocol_table.hpp as they stand in docs/protocol.md, between the lines
/// `protocol_text_begin` and `protocol_text_end`.
std::string protocol_text();

inline constexpr const char* protocol_text_begin = "<!-- printed by print_protocol_table: begin -->\n";
inline constexpr const char* protocol_text_end = "<!-- printed by print_protocol_table: end -->\n";

/// `page` with that block as it is now. Throws std::runtime_error if the two lines are not there.
std::string with_protocol_text(const std::string& page);

/// The whole file. Throws std::runtime_error if it cannot be read.
std::string content_of(const std::string& file);

}  // namespace fissura::test
