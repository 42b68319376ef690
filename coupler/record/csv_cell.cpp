// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/csv_cell.hpp"

namespace fissura::coupler {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

}  // namespace fissura::coupler
