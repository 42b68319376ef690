// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/segment_index.hpp"

#include <fmt/format.h>

#include <sstream>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/sealed_line.hpp"

namespace fissura::coupler {

std::vector<nlohmann::json> segment_index(const std::filesystem::path& index) {
  std::istringstream stream(read_whole_file(index));
  std::vector<nlohmann::json> lines;
  // A last line without its end is still being written.
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    try {
      lines.push_back(opened_line(line));
    } catch (const StorageError& fault) {
      throw StorageError(
          fmt::format("{} is damaged in line {}: {}", index.string(), lines.size() + 1, fault.what()));
    }
  }
  return lines;
}

Hdf5File open_segment(const std::filesystem::path& folder, const nlohmann::json& line) {
  std::string name, sha256;
  try {
    line.at("file").get_to(name);
    line.at("sha256").get_to(sha256);
  } catch (const nlohmann::json::exception& fault) {
    throw StorageError(
        fmt::format("{} names no segment: {}", (folder / "index.jsonl").string(), fault.what()));
  }
  const std::filesystem::path file = folder / name;
  if (!std::filesystem::is_regular_file(file))
    throw StorageError(fmt::format("{} is missing: index.jsonl names it", file.string()));
  if (sha256_of_file(file) != sha256)
    throw StorageError(fmt::format(
        "{} is damaged: its SHA-256 is not that of index.jsonl; coupler verify tells which arrays are lost",
        file.string()));
  return Hdf5File::open(file);
}

}  // namespace fissura::coupler
