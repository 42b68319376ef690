// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace fissura::fuzz {

namespace fs = std::filesystem;

namespace {
constexpr std::string_view mark = "=== ";
}

Folder::Folder()
    : path_(fs::path(fs::exists("/dev/shm") ? "/dev/shm" : "/tmp") /
            ("fissura-fuzz-" + std::to_string(::getpid()))) {
  fs::create_directories(path_);
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void Folder::fill(std::string_view input, const std::string& first,
                  std::initializer_list<std::string_view> names) {
  for (const auto& entry : fs::directory_iterator(path_)) fs::remove_all(entry.path());
  std::string name = first;
  std::size_t begin = 0;
  for (std::size_t line = 0; line < input.size();) {
    const std::size_t end = std::min(input.find('\n', line), input.size());
    const std::string_view text = input.substr(line, end - line);
    const std::size_t next = std::min(end + 1, input.size());
    if (text.starts_with(mark) &&
        std::find(names.begin(), names.end(), text.substr(mark.size())) != names.end()) {
      write(name, input.substr(begin, line - begin));
      name = text.substr(mark.size());
      begin = next;
    }
    line = next;
  }
  write(name, input.substr(begin));
}

void Folder::write(const std::string& name, std::string_view content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
}

}  // namespace fissura::fuzz
