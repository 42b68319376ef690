// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/record/scripted_run.hpp"

#include <cmath>
#include <set>

#include "tests/coupler/record/sample_run.hpp"

namespace fissura::coupler::sample {

namespace {

/// Grown, and remeshed, at every fifth interval.
std::uint64_t growths(std::uint64_t number) {
  return number / 5;
}

FractureNetwork network_after(std::uint64_t number) {
  return growths(number) == 0 ? network() : grown_network();
}

std::vector<SourceRecord> sources_of(std::uint64_t number) {
  std::vector<SourceRecord> records(number % 3);
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].kind = SourceKind::new_crack;
    records[i].entity = number + i;
    records[i].interval = number;
    records[i].end = 0.1 * static_cast<double>(number);
    records[i].moment = {1.0 / static_cast<double>(number + 1), 2, 3, -4};
  }
  return records;
}

Remeshing remeshing_of(std::uint64_t number) {
  Remeshing entry;
  entry.fracture = "slit";
  entry.x = std::sqrt(static_cast<double>(number));
  entry.elements_removed = number;
  entry.elements_made = number + 2;
  entry.hash_before = entry.hash_after = "ab12";
  entry.stable_step_before = 1e-5;
  entry.stable_step_after = 0.9e-5;
  entry.smallest_angle = 0.5;
  return entry;
}

Meeting meeting_of(std::uint64_t number) {
  Meeting meeting;
  meeting.time = 0.1 * static_cast<double>(number);
  meeting.hydraulic = "slit";
  meeting.natural = "joint, old";
  meeting.criterion = "renshaw-pollard";
  meeting.crosses = number % 2 == 0;
  return meeting;
}

ProbeValues probe_of(std::uint64_t number) {
  ProbeValues values;
  values.stress_xx = -1e7 / 3 * static_cast<double>(number);
  if (number % 4 == 0) values.slip = 1e-5 * static_cast<double>(number);
  return values;
}

}  // namespace

RunDescription description() {
  RunDescription result;
  result.run_id = "0123";
  result.title = "sample";
  result.effective_case = {{"title", "sample"}};
  result.probes = {"near", "far"};
  return result;
}

void record_interval(RunRecord& record, std::uint64_t number) {
  const double time = 0.1 * static_cast<double>(number);
  const FractureNetwork now = network_after(number);
  record.sources(time, sources_of(number));
  IntervalRecord figures = interval(number, time);
  figures.inlet_aperture = std::sin(static_cast<double>(number)) / 3;
  figures.ledger = {1e-3 * time, 0, 0, 9e-4 * time, 1e-4 * time, 0, 0, 0};
  figures.ledger.residual = figures.ledger.injected - figures.ledger.in_fractures - figures.ledger.leaked;
  record.interval(figures, {probe_of(number), probe_of(number + 1)});
  if (number % 2 == 0) {
    Message fields = structure_fields(time, growths(number), growths(number));
    if (number % 4 == 0) fields = with_joints(fields, time);
    record.fields(time, fields, network_fields(now), now, node_fields(now, time));
  }
  if (growths(number) > growths(number - 1)) {
    record.topology(now);
    record.remeshing(now, {remeshing_of(number)});
    if (number % 10 == 0) record.meetings(now, {meeting_of(number)});
  }
}

void record_intervals(RunRecord& record, std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t number = first; number <= last; ++number) record_interval(record, number);
}

void record_run(const std::filesystem::path& directory, std::uint64_t last) {
  RunRecord record(directory, reports_per_segment);
  record.begin(description());
  record_intervals(record, 1, last);
  record.finish({{"verdict", "none"}, {"intervals", last}});
}

std::map<std::string, std::string> comparable_files(const std::filesystem::path& directory) {
  const std::set<std::string> of_the_clock{"log.jsonl", "remeshing_wall.csv", "run.json", "SHA256SUMS",
                                           "lock"};
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    const std::string name = std::filesystem::relative(entry.path(), directory).string();
    if (entry.is_regular_file() && !of_the_clock.contains(name) && !name.ends_with(".superseded"))
      files[name] = content(entry.path());
  }
  return files;
}

std::vector<std::string> differences(const std::map<std::string, std::string>& one,
                                     const std::map<std::string, std::string>& other) {
  std::set<std::string> names;
  for (const auto* files : {&one, &other})
    for (const auto& [name, text] : *files) names.insert(name);
  std::erase_if(names, [&](const std::string& name) {
    return one.contains(name) && other.contains(name) && one.at(name) == other.at(name);
  });
  return {names.begin(), names.end()};
}

}  // namespace fissura::coupler::sample
