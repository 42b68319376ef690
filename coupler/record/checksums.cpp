// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/checksums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

constexpr std::array result_files{"run.json",
                                  "effective_case.json",
                                  "columns.json",
                                  "history.csv",
                                  "ledger.csv",
                                  "probes.csv",
                                  "remeshing.csv",
                                  "remeshing_wall.csv",
                                  "meetings.csv",
                                  "log.jsonl",
                                  "fields.xdmf",
                                  "fractures.xdmf",
                                  "joints.xdmf",
                                  "natural_fractures.csv",
                                  "natural_fractures.json",
                                  "summary.json",
                                  "resume.json"};
constexpr std::array result_folders{"input", "segments", "seismicity", "tape"};
constexpr std::size_t hash_digits = 64;
constexpr std::string_view separator = "  ";

bool is_result(const fs::path& file) {
  const std::string name = file.filename().string();
  return !name.ends_with(".part") && !name.ends_with(".superseded");
}

void add(const fs::path& run_directory, const fs::path& file, const Checksums& known, Checksums& sums) {
  const std::string name = file.lexically_relative(run_directory).string();
  const auto hash = known.find(name);
  sums[name] = hash != known.end() ? hash->second : sha256_of_file(file);
}

}  // namespace

void write_checksums(const fs::path& run_directory, const Checksums& known) {
  Checksums sums;
  for (const char* name : result_files)
    if (fs::is_regular_file(run_directory / name)) add(run_directory, run_directory / name, known, sums);
  for (const char* folder : result_folders) {
    std::error_code failure;
    const bool exists = fs::exists(run_directory / folder, failure);
    if (failure) throw StorageError(fmt::format("cannot read {}: {}", folder, failure.message()));
    if (!exists) continue;
    for (const auto& entry : fs::recursive_directory_iterator(run_directory / folder, failure))
      if (entry.is_regular_file() && is_result(entry.path())) add(run_directory, entry.path(), known, sums);
    if (failure) throw StorageError(fmt::format("cannot read {}: {}", folder, failure.message()));
  }
  std::string text;
  for (const auto& [name, hash] : sums) text += fmt::format("{}{}{}\n", hash, separator, name);
  write_whole_file(run_directory / "SHA256SUMS", text);
}

Checksums read_checksums(const fs::path& file) {
  const std::string text = read_whole_file(file);
  Checksums sums;
  for (std::size_t begin = 0, end; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    if (line.size() <= hash_digits + separator.size() ||
        line.substr(hash_digits, separator.size()) != separator)
      throw StorageError(fmt::format("{}: \"{}\" is no line of checksums", file.string(), line));
    sums[std::string(line.substr(hash_digits + separator.size()))] = line.substr(0, hash_digits);
  }
  return sums;
}

}  // namespace fissura::coupler
