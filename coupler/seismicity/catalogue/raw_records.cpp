// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/raw_records.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "coupler/record/segment_index.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

/// Numbers of the first and the last group of a segment; none if the first is the greater.
std::pair<std::uint64_t, std::uint64_t> groups_in(const nlohmann::json& segment, const fs::path& index) {
  if (!segment.contains("sources"))
    throw Error(
        ExitCode::precondition,
        fmt::format("{} tells nothing of seismic sources: the run is of an earlier version", index.string()));
  try {
    return segment.at("sources").get<std::pair<std::uint64_t, std::uint64_t>>();
  } catch (const nlohmann::json::exception& fault) {
    throw StorageError(fmt::format("{} is damaged: {}", index.string(), fault.what()));
  }
}

std::vector<SourceRecord> records_in(const Hdf5File& file, const std::string& group) {
  std::vector<Array> arrays;
  for (const Array& known : arrays_of({SourceRecord{}})) {
    arrays.push_back(file.read(group + "/" + known.name));
    arrays.back().name = known.name;
  }
  return records_of(arrays);
}

}  // namespace

std::uint64_t for_each_source_group(
    const fs::path& run_directory,
    const std::function<void(double time, const std::vector<SourceRecord>&)>& take) {
  const fs::path folder = run_directory / "segments", index = folder / "index.jsonl";
  if (!fs::exists(index))
    throw Error(ExitCode::precondition,
                fmt::format("{} is not there: is it a run directory with a closed segment?", index.string()));
  std::uint64_t groups = 0;
  for (const nlohmann::json& segment : segment_index(index)) {
    const auto [first, last] = groups_in(segment, index);
    if (first > last) continue;
    const Hdf5File file = open_segment(folder, segment);
    for (std::uint64_t number = first; number <= last; ++number) {
      const std::string group = fmt::format("/sources/{:06}", number);
      take(file.read_number(group, "time"), records_in(file, group));
      ++groups;
    }
  }
  return groups;
}

}  // namespace fissura::coupler
