// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fissura::coupler::sample {

/// A fresh directory in the system's temporary folder, removed at the end.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Of a file that is there.
std::string content(const std::filesystem::path& file);
std::vector<std::string> lines(const std::filesystem::path& file);

}  // namespace fissura::coupler::sample
