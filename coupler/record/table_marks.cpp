// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/table_marks.hpp"

#include <fmt/format.h>

#include <system_error>

namespace fissura::coupler {

void put(ByteWriter& archive, const TableMarks& marks) {
  archive.put(static_cast<std::uint64_t>(marks.size()));
  for (const auto& [name, mark] : marks) {
    archive.put(name);
    archive.put(mark.bytes);
    archive.put(mark.crc32);
  }
}

TableMarks get_marks(ByteReader& archive) {
  TableMarks marks;
  std::uint64_t count = 0;
  archive.get(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    std::string name;
    FileMark mark;
    archive.get(name);
    archive.get(mark.bytes);
    archive.get(mark.crc32);
    marks[name] = mark;
  }
  return marks;
}

void check_marks(const std::filesystem::path& run_directory, const TableMarks& marks) {
  for (const auto& [name, mark] : marks) check_mark(run_directory / name, mark);
}

std::optional<CheckedFile> at_mark(const std::filesystem::path& run_directory, const std::string& name,
                                   const TableMarks& marks) {
  const auto mark = marks.find(name);
  if (mark != marks.end()) return CheckedFile(run_directory / name, mark->second);
  remove_file(run_directory / name);
  return std::nullopt;
}

void remove_file(const std::filesystem::path& file) {
  std::error_code failure;
  std::filesystem::remove(file, failure);
  if (failure) throw StorageError(fmt::format("cannot remove {}: {}", file.string(), failure.message()));
}

}  // namespace fissura::coupler
