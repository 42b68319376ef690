// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/segment_files.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <system_error>
#include <vector>

#include "common/errors.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/table_marks.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

std::optional<std::uint64_t> number_of(const std::string& name) {
  std::uint64_t number = 0;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (failure != std::errc() || segment_name(number) != name) return std::nullopt;
  return number;
}

fs::path superseded(const fs::path& segment) {
  fs::path free = segment.string() + ".superseded";
  for (int number = 2; fs::exists(free); ++number)
    free = fmt::format("{}.{}.superseded", segment.string(), number);
  return free;
}

}  // namespace

std::string segment_name(std::uint64_t number) {
  return fmt::format("{:06}.h5", number);
}

void supersede_segments_after(std::uint64_t last, const fs::path& folder) {
  if (!fs::exists(folder)) return;
  std::vector<fs::path> newer, parts;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    const std::string name = entry.path().filename().string();
    if (const auto number = number_of(name); number && *number > last) newer.push_back(entry.path());
    if (name.ends_with(".part")) parts.push_back(entry.path());
  }
  for (const fs::path& segment : newer)
    if (!failure) fs::rename(segment, superseded(segment), failure);
  if (failure)
    throw StorageError(
        fmt::format("cannot supersede segments in {}: {}", folder.string(), failure.message()));
  for (const fs::path& part : parts) remove_file(part);
  sync_to_disk(folder);
}

}  // namespace fissura::coupler
