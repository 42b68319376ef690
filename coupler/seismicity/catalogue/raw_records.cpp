// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/raw_records.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "coupler/record/hdf5_file.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

std::vector<nlohmann::json> closed_segments(const fs::path& index) {
  std::ifstream stream(index);
  if (!stream)
    throw Error(
        ExitCode::precondition,
        fmt::format("{} cannot be read: is it a run directory with a closed segment?", index.string()));
  std::vector<nlohmann::json> segments;
  // A last line without its end is still being written.
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    try {
      segments.push_back(nlohmann::json::parse(line));
      if (!segments.back().contains("sources"))
        throw Error(ExitCode::precondition,
                    fmt::format("{} tells nothing of seismic sources: the run is of an earlier version",
                                index.string()));
    } catch (const nlohmann::json::exception& fault) {
      throw StorageError(fmt::format("{} is damaged: {}", index.string(), fault.what()));
    }
  }
  return segments;
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
  std::uint64_t groups = 0;
  for (const nlohmann::json& segment : closed_segments(run_directory / "segments" / "index.jsonl")) {
    const auto [first, last] = segment.at("sources").get<std::pair<std::uint64_t, std::uint64_t>>();
    if (first > last) continue;
    const Hdf5File file = Hdf5File::open(run_directory / "segments" / segment.at("file").get<std::string>());
    for (std::uint64_t number = first; number <= last; ++number) {
      const std::string group = fmt::format("/sources/{:06}", number);
      take(file.read_number(group, "time"), records_in(file, group));
      ++groups;
    }
  }
  return groups;
}

}  // namespace fissura::coupler
