// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/run_record.hpp"

#include <fmt/format.h>

#include <csignal>
#include <sstream>
#include <system_error>

#include "common/errors.hpp"
#include "common/log.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/checksums.hpp"
#include "coupler/record/sealed_line.hpp"
#include "coupler/record/segment_files.hpp"
#include "coupler/record/xdmf.hpp"

namespace fissura::coupler {

namespace {

namespace fs = std::filesystem;

const std::string format_of_state = "record 1";
constexpr const char *segments_folder = "segments", *run_name = "run.json", *summary_name = "summary.json",
                     *checksums_name = "SHA256SUMS";

void copy_inputs(const std::vector<fs::path>& files, const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw StorageError(fmt::format("cannot create {}: {}", folder.string(), failure.message()));
  for (const auto& file : files) {
    const fs::path copy = folder / file.filename();
    if (fs::exists(copy) && fs::equivalent(file, copy)) continue;
    fs::copy_file(file, copy, fs::copy_options::overwrite_existing, failure);
    if (failure)
      throw StorageError(
          fmt::format("cannot copy {} to {}: {}", file.string(), folder.string(), failure.message()));
    sync_to_disk(copy);
  }
  sync_to_disk(folder);
}

/// run.json of an earlier life of the same run under the same program, with the participants of now, or else
/// the one that says that it begins now.
std::string run_text(const fs::path& file, const RunDescription& description) {
  const nlohmann::json content = run_json(description);
  if (!fs::exists(file)) return sealed_run_text(content);
  try {
    const std::string text = read_whole_file(file);
    nlohmann::json earlier = opened_run_text(text);
    const auto agree = [&](const char* key) { return earlier.value(key, "") == content.at(key); };
    if (agree("run_id") && agree("columns")) {
      earlier["participants"] = content["participants"];
      earlier.erase("network_changes");
      return sealed_run_text(earlier);
    }
  } catch (const StorageError& fault) {
    log::warn(
        fmt::format("{} is damaged and written anew, with the time of now: {}", file.string(), fault.what()));
  }
  return sealed_run_text(content);
}

std::string started_of(const std::string& run_text) {
  return opened_run_text(run_text).at("started").get<std::string>();
}

std::string started_in_state(const std::string& run_text) {
  try {
    return started_of(run_text);
  } catch (const std::exception& fault) {
    throw Error(ExitCode::checkpoint_unusable,
                fmt::format("{} in the state of the record: {}", run_name, fault.what()));
  }
}

/// Says that the run is finished: it goes before anything else is changed.
void remove_signs_of_the_end(const fs::path& directory) {
  for (const char* name : {summary_name, checksums_name}) remove_file(directory / name);
  sync_to_disk(directory);
}

void remove_earlier_life(const fs::path& directory) {
  remove_signs_of_the_end(directory);
  remove_file(directory / segments_folder / "index.jsonl");
  supersede_segments_after(0, directory / segments_folder);
  for (const char* name : {"remeshing.csv", "remeshing_wall.csv", "meetings.csv", "probes.csv", "fields.xdmf",
                           "fractures.xdmf", "joints.xdmf"})
    remove_file(directory / name);
}

/// A file that somebody has removed still takes every line.
void require_size(const fs::path& file, std::uintmax_t expected) {
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure || size != expected)
    throw StorageError(fmt::format("{} was removed or replaced while the run wrote it", file.string()));
}

TableMarks read_marks(ByteReader& archive) {
  std::string format;
  archive.get(format);
  if (format != format_of_state)
    throw Error(ExitCode::checkpoint_unusable,
                "the state of the record is of another version of the program");
  return get_marks(archive);
}

Checksums hashes_of_segments(const fs::path& index) {
  Checksums hashes;
  if (!fs::exists(index)) return hashes;
  std::istringstream lines(read_whole_file(index));
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json segment = opened_line(line);
    hashes[fmt::format("{}/{}", segments_folder, segment.at("file").get<std::string>())] =
        segment.at("sha256").get<std::string>();
  }
  return hashes;
}

}  // namespace

RunRecord::RunRecord(const std::filesystem::path& directory, int reports_per_segment)
    : directory_(directory),
      remesh_ledger_(directory_),
      meeting_ledger_(directory_),
      segments_(directory_, reports_per_segment) {
  std::signal(SIGXFSZ, SIG_IGN);
}

void RunRecord::begin(const RunDescription& description) {
  remove_earlier_life(directory());
  events_.emplace(directory() / "log.jsonl");
  history_.observe(description.probes);
  history_.write_to(directory());
  copy_inputs(description.input_files, directory() / "input");
  write_whole_file(directory() / "effective_case.json", description.effective_case.dump(2) + "\n");
  run_json_ = run_text(directory() / run_name, description);
  started_ = started_of(run_json_);
  write_whole_file(directory() / run_name, run_json_);
}

void RunRecord::save_parts(TableMarks& marks, ByteWriter& archive) {
  history_.save(marks, archive);
  remesh_ledger_.save(marks, archive);
  meeting_ledger_.save(marks, archive);
  segments_.save(marks, archive);
  sync_to_disk(directory());
  for (const auto& [name, mark] : marks) require_size(directory() / name, mark.bytes);
}

std::vector<std::byte> RunRecord::save() {
  TableMarks marks;
  ByteWriter parts;
  save_parts(marks, parts);
  ByteWriter archive;
  archive.put(format_of_state);
  put(archive, marks);
  archive.put(run_json_);
  archive.put(interval_);
  archive.put(time_);
  archive.put(sources_time_);
  archive.put(sources_);
  archive.put(parts.take());
  return archive.take();
}

TableMarks RunRecord::marks(const std::vector<std::byte>& bytes) {
  ByteReader archive(bytes);
  return read_marks(archive);
}

void RunRecord::check(const fs::path& directory, const std::vector<std::byte>& bytes) {
  check_marks(directory, marks(bytes));
}

void RunRecord::resume(const RunDescription& description, const std::vector<std::byte>& bytes) {
  check(directory(), bytes);
  ByteReader archive(bytes);
  const TableMarks marks = read_marks(archive);
  std::vector<std::byte> parts_bytes;
  archive.get(run_json_);
  archive.get(interval_);
  archive.get(time_);
  archive.get(sources_time_);
  archive.get(sources_);
  archive.get(parts_bytes);
  archive.end();
  started_ = started_in_state(run_json_);

  remove_signs_of_the_end(directory());
  events_.emplace(directory() / "log.jsonl");
  history_.observe(description.probes);
  ByteReader parts(parts_bytes);
  history_.resume(directory(), marks, parts);
  remesh_ledger_.resume(marks, parts);
  meeting_ledger_.resume(marks, parts);
  segments_.resume(marks, parts);
  parts.end();
  write_whole_file(directory() / "effective_case.json", description.effective_case.dump(2) + "\n");
  write_whole_file(directory() / run_name, run_json_);
  for (const char* name : {"fields.xdmf", "fractures.xdmf", "joints.xdmf"}) remove_file(directory() / name);
  if (!segments_.closed().reports.empty()) write_xdmf(directory(), segments_.closed());
}

void RunRecord::network_changed(const nlohmann::json& entry) {
  nlohmann::json content = opened_run_text(run_json_);
  content["network_changes"].push_back(entry);
  run_json_ = sealed_run_text(std::move(content));
  write_whole_file(directory() / run_name, run_json_);
}

void RunRecord::topology(const FractureNetwork& network) {
  event(EventLevel::info, "coupler", "topology",
        fmt::format("revision {}: {} nodes, {} segments", network.revision(), network.nodes().size(),
                    network.segments().size()));
}

void RunRecord::remeshing(const FractureNetwork& network, const std::vector<Remeshing>& entries) {
  for (const Remeshing& entry : entries) remesh_ledger_.add(network.revision(), time_, entry);
}

void RunRecord::meetings(const FractureNetwork& network, const std::vector<Meeting>& meetings) {
  for (const Meeting& meeting : meetings) {
    meeting_ledger_.add(network.revision(), meeting);
    event(EventLevel::info, "structure", "meeting", sentence(meeting));
  }
}

void RunRecord::interval(const IntervalRecord& record, const std::vector<ProbeValues>& probes) {
  history_.add(record, probes);
  interval_ = record.interval;
  time_ = record.time;
}

void RunRecord::sources(double time, const std::vector<SourceRecord>& records) {
  sources_.insert(sources_.end(), records.begin(), records.end());
  sources_time_ = time;
}

void RunRecord::write_sources() {
  segments_.add_sources(sources_time_, sources_);
  sources_.clear();
}

void RunRecord::fields(double time, const Message& structure_fields, const Message& network_fields,
                       const FractureNetwork& network, const std::vector<NodeField>& node_fields) {
  history_.flush();
  remesh_ledger_.flush();
  meeting_ledger_.flush();
  write_sources();
  if (segments_.add(time, structure_fields, network_fields, network, node_fields))
    write_xdmf(directory(), segments_.closed());
}

void RunRecord::event(EventLevel level, const std::string& participant, const std::string& event,
                      const std::string& text) {
  ENSURE(events_.has_value());
  events_->add({interval_, time_, level, participant, event, text});
}

void RunRecord::close() {
  history_.flush();
  remesh_ledger_.flush();
  meeting_ledger_.flush();
  write_sources();
  if (segments_.close()) write_xdmf(directory(), segments_.closed());
}

void RunRecord::finish(const nlohmann::ordered_json& summary) {
  close();
  write_whole_file(directory() / summary_name, summary.dump(2) + "\n");
  if (!events_) return;
  TableMarks marks;
  ByteWriter unused;
  save_parts(marks, unused);
  try {
    check_marks(directory(), marks);
  } catch (const Error& damage) {
    throw StorageError(damage.what());
  }
  write_checksums(directory(), hashes_of_segments(directory() / segments_folder / "index.jsonl"));
}

}  // namespace fissura::coupler
