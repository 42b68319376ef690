// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "common/case/case_json.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/segments.hpp"
#include "coupler/seismicity/analysis/analysis_json.hpp"
#include "coupler/seismicity/catalogue/catalogue.hpp"
#include "tests/coupler/seismicity/catalogue/sample_events.hpp"

// sample_catalogue DIR EVENTS [unplaced]
// Writes what a run with that many events leaves behind: case, run.json, history, records of sources in two
// segments, and the catalogue in all formats. Prints the seconds that each of them took, as JSON.
namespace {

using namespace fissura;
using namespace fissura::coupler;
namespace fs = std::filesystem;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void write_records(const fs::path& directory, const std::vector<SourceRecord>& records) {
  Segments segments(directory, 1);
  const auto half = records.begin() + static_cast<std::ptrdiff_t>(records.size() / 2);
  const double time = half == records.begin() ? 0.0 : static_cast<double>(std::prev(half)->interval);
  segments.add_sources(time, {records.begin(), half});
  segments.close();
  segments.add_sources(time + static_cast<double>(records.size()), {half, records.end()});
  segments.close();
}

std::vector<SeismicEvent> extract(Extraction& extraction, const std::vector<SourceRecord>& records) {
  std::vector<SeismicEvent> events;
  const auto take = [&](const std::vector<SeismicEvent>& closed) {
    events.insert(events.end(), closed.begin(), closed.end());
  };
  for (auto begin = records.begin(); begin != records.end();) {
    const std::uint64_t interval = begin->interval;
    auto end = begin;
    while (end != records.end() && end->interval == interval) ++end;
    take(extraction.advance(static_cast<double>(interval), {begin, end}));
    begin = end;
  }
  take(extraction.finish());
  return events;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const fs::path directory = argv[1];
  Case run_case = sample::placed_case();
  CatalogueContext context = sample::placed_context();
  if (argc > 3) run_case.georeference.reset(), context = sample::context_without_place();
  fs::create_directories(directory);
  write_whole_file(directory / "effective_case.json", case_to_json(run_case).dump());
  write_whole_file(
      directory / "run.json",
      nlohmann::json{{"run_id", context.run_id}, {"title", context.title}, {"started", context.started}}
          .dump());

  const std::vector<SourceRecord> records =
      sample::random_sources(static_cast<std::size_t>(std::atoll(argv[2])), 1);
  write_records(directory, records);
  Extraction extraction(context.controls);
  const std::vector<SeismicEvent> events = extract(extraction, records);
  const InjectedVolume injected{{0, 100}, {0, 1}};
  write_whole_file(directory / "history.csv", "time,injected\n0,0\n100,1\n");
  const nlohmann::json analysis = analysis_json(events, run_case, injected, extraction.sums());
  nlohmann::ordered_json seconds;
  for (const char* word : {"csv", "hdf5", "points", "quakeml"}) {
    const CatalogueFormat format = format_of(word);
    if (!possible_formats(context).contains(format)) continue;
    seconds[word] = seconds_of([&] {
      write_catalogue(directory / "one_format", events, extraction.sums(), context, nullptr, {{format}, {}});
    });
  }
  fs::remove_all(directory / "one_format");
  seconds["all"] = seconds_of([&] {
    write_catalogue(directory / "seismicity", events, extraction.sums(), context, analysis,
                    {possible_formats(context), std::nullopt});
  });
  fmt::print("{}\n", nlohmann::ordered_json{{"events", events.size()}, {"seconds", seconds}}.dump());
}
