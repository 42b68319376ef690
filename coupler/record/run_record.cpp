// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/run_record.hpp"

#include <fmt/format.h>

#include <csignal>
#include <system_error>

#include "common/errors.hpp"
#include "coupler/record/checked_file.hpp"
#include "coupler/record/xdmf.hpp"

namespace fissura::coupler {

namespace {

void copy_inputs(const std::vector<std::filesystem::path>& files, const std::filesystem::path& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw StorageError(fmt::format("cannot create {}: {}", folder.string(), failure.message()));
  for (const auto& file : files) {
    std::filesystem::copy_file(file, folder / file.filename(), failure);
    if (failure)
      throw StorageError(
          fmt::format("cannot copy {} to {}: {}", file.string(), folder.string(), failure.message()));
  }
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
  events_.emplace(directory() / "log.jsonl");
  history_.observe(description.probes);
  history_.write_to(directory());
  copy_inputs(description.input_files, directory() / "input");
  write_whole_file(directory() / "effective_case.json", description.effective_case.dump(2) + "\n");
  const nlohmann::json run = run_json(description);
  started_ = run.at("started").get<std::string>();
  write_whole_file(directory() / "run.json", run.dump(2) + "\n");
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
  write_whole_file(directory() / "summary.json", summary.dump(2) + "\n");
}

}  // namespace fissura::coupler
