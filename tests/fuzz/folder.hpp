// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fissura::fuzz {

/// A folder in memory that lasts as long as the program.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// Empties it and fills it with the files that `input` holds: the text up to the first line "=== NAME" is
  /// the file `first`, what follows such a line the file NAME (one of `names`; the line is content if it is
  /// none).
  void fill(std::string_view input, const std::string& first, std::initializer_list<std::string_view> names);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void write(const std::string& name, std::string_view content) const;

  std::filesystem::path path_;
};

}  // namespace fissura::fuzz
