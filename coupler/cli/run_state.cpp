// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/run_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "coupler/launch/last_line.hpp"
#include "coupler/launch/run_report.hpp"
#include "coupler/record/run_directory.hpp"

namespace fissura::coupler {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array roles{"structure", "network"};

/// The letter of /proc/PID/stat: 'T' is stopped by a signal, 'Z' ended; nothing if there is no such process.
std::optional<char> process_state(std::int64_t pid) {
  std::ifstream stream(fmt::format("/proc/{}/stat", pid));
  std::string text;
  std::getline(stream, text);
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos || name_end + 2 >= text.size()) return std::nullopt;
  return text[name_end + 2];
}

std::string process_word(const ParticipantStatus& participant) {
  if (participant.pid <= 0) return "elsewhere";
  const std::optional<char> state = process_state(participant.pid);
  if (!state || *state == 'Z' || *state == 'X') return "gone";
  return *state == 'T' || *state == 't' ? "stopped" : "alive";
}

std::optional<double> seconds_left(const RunStatus& status) {
  const double simulated = status.time - status.started_time;
  if (!(simulated > 0)) return std::nullopt;
  return (monotonic_seconds() - status.started_at) * (status.end - status.time) / simulated;
}

Json participant_json(const ParticipantStatus& participant, double now) {
  if (participant.asked.text().empty()) return {{"asked", nullptr}, {"waited_for", true}};
  return {{"asked", participant.asked.text()},
          {"interval", participant.interval},
          {"asked_seconds", now - participant.asked_at},
          {"phase", participant.phase.text()},
          {"count", participant.count},
          {"silent_seconds", now - participant.last_word},
          {"pid", participant.pid},
          {"process", process_word(participant)},
          {"waited_for", participant.is_waited_for}};
}

Json status_json(const RunStatus& status) {
  Json json{{"time", status.time},
            {"end", status.end},
            {"interval", status.interval},
            {"duration", status.duration},
            {"drift", status.drift},
            {"insertions", status.insertions},
            {"ledger",
             {{"injected", status.injected},
              {"in_fractures", status.in_fractures},
              {"leaked", status.leaked},
              {"residual", status.ledger_residual}}}};
  json["phase"] = status.phase.text();
  return json;
}

/// What only makes sense while the run goes on.
void add_moment(const RunStatus& status, Json& json) {
  const double now = monotonic_seconds();
  json["phase_seconds"] = now - status.phase_since;
  json["wall_seconds"] = now - status.started_at;
  const std::optional<double> left = seconds_left(status);
  json["wall_seconds_left"] = left ? Json(*left) : Json(nullptr);
  json["waits_for"] = Json::array();
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const Json participant = participant_json(status.participants[i], now);
    if (participant["waited_for"].get<bool>()) json["waits_for"].push_back(roles[i]);
    json["participants"][roles[i]] = participant;
  }
}

std::string line(const char* label, const std::string& text) {
  return fmt::format("{:<12}{}\n", label, text);
}

std::string participant_text(const ParticipantStatus& participant, double now) {
  if (participant.asked.text().empty()) return "has not introduced itself";
  const std::string process = process_word(participant);
  std::string text =
      participant.is_waited_for
          ? fmt::format("at {} of interval {} since {:.2f} s", participant.asked.text(), participant.interval,
                        now - participant.asked_at)
          : fmt::format("has answered {} of interval {}", participant.asked.text(), participant.interval);
  if (!participant.phase.text().empty())
    text += fmt::format(", phase {}, loop count {}", participant.phase.text(), participant.count);
  text += fmt::format(", last word {:.2f} s ago", now - participant.last_word);
  if (process == "stopped") text += ", STOPPED by a signal";
  if (process == "gone") text += ", its process is GONE";
  return text;
}

std::string moment_text(const RunStatus& status) {
  const double now = monotonic_seconds();
  std::string text, waits_for;
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (status.participants[i].is_waited_for)
      waits_for += (waits_for.empty() ? "" : " and ") + std::string(roles[i]);
  text += line("coupler",
               fmt::format("in phase {} since {:.2f} s, {}", status.phase.text(), now - status.phase_since,
                           waits_for.empty() ? "waits for nobody" : "waits for " + waits_for));
  for (std::size_t i = 0; i < roles.size(); ++i)
    text += line(roles[i], participant_text(status.participants[i], now));
  return text;
}

std::string reached_text(const RunStatus& status, bool running) {
  const double part = status.end > 0 ? 100 * status.time / status.end : 0;
  const std::optional<double> left = running ? seconds_left(status) : std::nullopt;
  return line("time", fmt::format("{:.6g} of {:.6g} s ({:.1f} %){}", status.time, status.end, part,
                                  left ? fmt::format(", about {:.0f} s of wall time left", *left) : "")) +
         line("interval", fmt::format("{}, {:.4g} s long, drift {:.2e}", status.interval, status.duration,
                                      status.drift)) +
         line("topology", fmt::format("{} insertions", status.insertions)) +
         line("ledger",
              fmt::format("injected {:.4e} m3, in fractures {:.4e} m3, leaked {:.4e} m3, residual {:.1e}",
                          status.injected, status.in_fractures, status.leaked, status.ledger_residual));
}

std::string checkpoint_text(const RunState& state) {
  if (!state.checkpoint) return line("checkpoint", "none");
  const bool known =
      state.status && state.status->has_checkpoint && state.status->checkpoint_interval == *state.checkpoint;
  return line("checkpoint", place(state.checkpoint) +
                                (known ? fmt::format(", {:.6g} s", state.status->checkpoint_time) : ""));
}

const char* word(const RunState& state) {
  if (state.supervisor) return "running";
  return state.report.is_object() ? "ended" : "killed";
}

std::string ended_text(const RunState& state) {
  if (!state.report.is_object())
    return line("killed",
                "the run is not going on and left no report: its supervisor was killed, or the machine "
                "failed") +
           line("resume",
                fmt::format("{} (from {})", resume_command(state.directory), place(state.checkpoint)));
  const std::string last = state.report.value("last_line", std::string());
  return line("ended", fmt::format("{} {} after {:.1f} s, epoch {}", state.report.value("code", 0),
                                   state.report.value("name", std::string()),
                                   state.report.value("wall_seconds", 0.0), state.report.value("epoch", 0))) +
         (last.empty() ? "" : line("last line", last));
}

}  // namespace

RunState read_run_state(const std::filesystem::path& directory) {
  RunState state;
  state.supervisor = RunDirectory::holder(directory);
  state.directory = std::filesystem::canonical(directory);
  state.status = read_status(directory / "status");
  state.checkpoint = newest_checkpoint(directory);
  std::ifstream stream(directory / run_report_name);
  if (stream && !state.supervisor) state.report = nlohmann::json::parse(stream, nullptr, false);
  return state;
}

nlohmann::ordered_json run_state_json(const RunState& state) {
  Json json{{"state", word(state)}, {"directory", state.directory.string()}};
  json["pid"] = state.supervisor ? Json(*state.supervisor) : Json(nullptr);
  if (state.status) {
    json["epoch"] = state.status->epoch;
    json.update(status_json(*state.status));
    if (state.supervisor) add_moment(*state.status, json);
  }
  json["checkpoint"] = state.checkpoint ? Json(*state.checkpoint) : Json(nullptr);
  if (state.report.is_object()) json["report"] = state.report;
  if (!state.supervisor && !state.report.is_object()) json["resume"] = resume_command(state.directory);
  return json;
}

std::string run_state_text(const RunState& state) {
  std::string text;
  if (!state.supervisor)
    text = ended_text(state);
  else if (state.status)
    text = line("running", fmt::format("for {:.1f} s, process {}, epoch {}",
                                       monotonic_seconds() - state.status->started_at, *state.supervisor,
                                       state.status->epoch));
  else
    text = line("running", fmt::format("process {}, starting", *state.supervisor));
  if (state.status) {
    text += reached_text(*state.status, state.supervisor.has_value());
    if (state.supervisor) text += moment_text(*state.status);
  }
  return text + checkpoint_text(state);
}

}  // namespace fissura::coupler
