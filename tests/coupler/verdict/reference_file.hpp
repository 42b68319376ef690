// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace fissura::coupler {

/// A file with a given text, removed at the end.
class ReferenceFile {
 public:
  explicit ReferenceFile(const std::string& text) {
    std::string pattern = (std::filesystem::temp_directory_path() / "fissura_reference_XXXXXX").string();
    const int descriptor = ::mkstemp(pattern.data());
    if (descriptor < 0) throw std::runtime_error("no temporary file");
    ::close(descriptor);
    path_ = pattern;
    std::ofstream(path_) << text;
  }
  ~ReferenceFile() { std::filesystem::remove(path_); }
  ReferenceFile(const ReferenceFile&) = delete;
  ReferenceFile& operator=(const ReferenceFile&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace fissura::coupler
