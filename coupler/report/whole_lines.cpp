// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/whole_lines.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "common/errors.hpp"

namespace fissura::coupler {

std::string whole_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) {
    // An empty file also fails to be streamed.
    std::error_code unknown;
    if (std::filesystem::file_size(file, unknown) == 0 && !unknown) return {};
    throw InputError(fmt::format("cannot read {}", file.string()));
  }
  return text.str();
}

std::vector<std::string> whole_lines(const std::filesystem::path& file) {
  const std::string text = whole_text(file);
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

}  // namespace fissura::coupler
