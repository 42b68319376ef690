// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/run_report.hpp"

#include <fstream>

#include "coupler/launch/last_line.hpp"

namespace fissura::coupler {

namespace {

using Json = nlohmann::ordered_json;

Json interval_of(const std::optional<std::uint64_t>& checkpoint) {
  return checkpoint ? Json(*checkpoint) : Json(nullptr);
}

/// An entry of run.json, null without.
Json entry_of_run(const std::filesystem::path& run_directory, const char* key) {
  std::ifstream stream(run_directory / "run.json");
  const Json run = Json::parse(stream, nullptr, false);
  return run.is_object() && run.contains(key) ? run[key] : Json(nullptr);
}

Json cause_of(const RunFailure& failure) {
  return {{"code", failure.exit_code},         {"name", name_of_code(failure.exit_code)},
          {"participant", failure.who.text()}, {"interval", failure.interval},
          {"phase", failure.phase.text()},     {"cause", failure.sentence.text()}};
}

}  // namespace

nlohmann::ordered_json run_report(const std::filesystem::path& run_directory, const RunEnd& end) {
  Json report{{"code", end.exit_code}, {"name", name_of_code(end.exit_code)}};
  if (end.failure.exit_code != 0) {
    report.update(cause_of(end.failure));
    report["last_line"] = end.last_line;
    if (can_resume_after(end.exit_code))
      report["resume"] = {{"command", resume_command(run_directory)},
                          {"interval", interval_of(end.checkpoint)}};
  }
  report["epoch"] = end.epoch;
  report["deaths"] = Json::array();
  for (const Death& death : end.deaths) {
    Json entry{{"epoch", death.epoch}};
    entry.update(cause_of(death.failure));
    entry["checkpoint"] = interval_of(death.checkpoint);
    report["deaths"].push_back(entry);
  }
  report["time"] = end.status.time;
  report["end"] = end.status.end;
  report["intervals"] = end.status.interval;
  report["wall_seconds"] = end.wall_seconds;
  report["run_id"] = entry_of_run(run_directory, "run_id");
  if (const Json changes = entry_of_run(run_directory, "network_changes"); changes.is_array())
    report["network_changes"] = changes;
  report["directory"] = run_directory.string();
  return report;
}

}  // namespace fissura::coupler
