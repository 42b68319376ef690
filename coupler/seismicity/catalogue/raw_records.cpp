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

struct SegmentOfSources {
  std::string file;
  std::uint64_t first = 0, last = 0;  ///< groups; none if first > last
};

std::vector<SegmentOfSources> closed_segments(const fs::path& index) {
  std::ifstream stream(index);
  if (!stream)
    throw Error(
        ExitCode::precondition,
        fmt::format("{} cannot be read: is it a run directory with a closed segment?", index.string()));
  std::vector<SegmentOfSources> segments;
  // A last line without its end is still being written.
  for (std::string line; std::getline(stream, line) && !stream.eof();) {
    try {
      const auto entry = nlohmann::json::parse(line);
      if (!entry.contains("sources"))
        throw Error(ExitCode::precondition,
                    fmt::format("{} tells nothing of seismic sources: the run is of an earlier version",
                                index.string()));
      const auto [first, last] = entry.at("sources").get<std::pair<std::uint64_t, std::uint64_t>>();
      segments.push_back({entry.at("file").get<std::string>(), first, last});
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
  for (const SegmentOfSources& segment : closed_segments(run_directory / "segments" / "index.jsonl")) {
    if (segment.first > segment.last) continue;
    const Hdf5File file = Hdf5File::open(run_directory / "segments" / segment.file);
    for (std::uint64_t number = segment.first; number <= segment.last; ++number) {
      const std::string group = fmt::format("/sources/{:06}", number);
      take(file.read_number(group, "time"), records_in(file, group));
      ++groups;
    }
  }
  return groups;
}

}  // namespace fissura::coupler
