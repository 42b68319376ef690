// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/prepared_run.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "common/case/case_json.hpp"
#include "common/errors.hpp"
#include "common/hash.hpp"
#include "coupler/record/checked_file.hpp"

namespace fissura {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ExpectedQuantity, name, unit, unit_in_si, measure, reference, from, to, at,
                                   value, expected_time, tolerance, bound, reason)

}  // namespace fissura

namespace fissura::coupler {

namespace {

using nlohmann::json;

constexpr const char* file_name = "resume.json";
constexpr int schema = 1;

std::string hash_of(const json& content) {
  const std::string text = content.dump();
  return sha256(std::as_bytes(std::span(text)));
}

json content_of(const PreparedRun& run) {
  return {{"schema", schema},
          {"run_id", run.run_id},
          {"case", case_to_json(run.reading.value)},
          {"folder", run.reading.folder},
          {"files", run.reading.files},
          {"expectations", run.expectations.quantities},
          {"end", run.end},
          {"structure_command", run.structure_command},
          {"network_command", run.network_command},
          {"network_since", run.network_since},
          {"keys", run.keys ? json(*run.keys) : json()},
          {"awaited", run.awaited},
          {"tape", run.tape},
          {"threads", run.threads},
          {"json", run.json},
          {"command_line", run.command_line}};
}

PreparedRun run_of(const json& content) {
  PreparedRun run;
  run.run_id = content.at("run_id").get<RunId>();
  run.reading.value = case_from_json(content.at("case"));
  run.reading.folder = content.at("folder").get<std::filesystem::path>();
  run.reading.files = content.at("files").get<std::vector<std::filesystem::path>>();
  run.expectations.quantities = content.at("expectations").get<std::vector<ExpectedQuantity>>();
  run.end = content.at("end").get<double>();
  run.structure_command = content.at("structure_command").get<std::string>();
  run.network_command = content.at("network_command").get<std::string>();
  run.network_since = content.value("network_since", run.network_since);
  if (const json& keys = content.at("keys"); !keys.is_null()) run.keys = keys.get<std::filesystem::path>();
  run.awaited = content.at("awaited").get<std::vector<std::string>>();
  run.tape = content.value("tape", run.tape);
  run.threads = content.at("threads").get<int>();
  run.json = content.at("json").get<bool>();
  run.command_line = content.at("command_line").get<std::vector<std::string>>();
  return run;
}

/// The case folder may have changed since; the run has copies.
void prefer_copies(const std::filesystem::path& folder, PreparedRun& run) {
  const auto prefer = [&](std::filesystem::path& file) {
    const std::filesystem::path copy = folder / file.filename();
    if (!file.empty() && std::filesystem::exists(copy)) file = copy;
  };
  for (ExpectedQuantity& quantity : run.expectations.quantities) prefer(quantity.reference);
  for (std::filesystem::path& file : run.reading.files) prefer(file);
}

}  // namespace

RunId random_run_id() {
  std::random_device source;
  RunId run;
  for (std::uint8_t& byte : run) byte = static_cast<std::uint8_t>(source());
  return run;
}

std::string hexadecimal(const RunId& run) {
  std::string text;
  for (const std::uint8_t byte : run) text += fmt::format("{:02x}", byte);
  return text;
}

void write_resume_file(const PreparedRun& run) {
  const json content = content_of(run);
  const json whole = {{"content", content}, {"sha256", hash_of(content)}};
  write_whole_file(run.directory / file_name, whole.dump(1) + "\n");
}

void change_network_in_resume_file(const PreparedRun& run) {
  PreparedRun there = read_resume_file(run.directory);
  there.network_command = run.network_command;
  there.network_since = run.network_since;
  there.awaited = run.awaited;
  write_resume_file(there);
}

PreparedRun read_resume_file(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / file_name;
  std::ifstream stream(file);
  if (!stream)
    throw Error(ExitCode::precondition, fmt::format("{} holds no run that could go on: there is no {}",
                                                    directory.string(), file_name));
  std::stringstream text;
  text << stream.rdbuf();
  try {
    const json whole = json::parse(text.str());
    const json& content = whole.at("content");
    if (whole.at("sha256").get<std::string>() != hash_of(content) || text.str() != whole.dump(1) + "\n")
      throw Error(ExitCode::checkpoint_unusable,
                  fmt::format("{} is damaged: its hash does not fit", file.string()));
    if (content.at("schema").get<int>() != schema)
      throw Error(ExitCode::checkpoint_unusable, fmt::format("{} is of another version", file.string()));
    PreparedRun run = run_of(content);
    run.directory = directory;
    prefer_copies(directory / "input", run);
    return run;
  } catch (const json::exception& fault) {
    throw Error(ExitCode::checkpoint_unusable,
                fmt::format("{} cannot be read: {}", file.string(), fault.what()));
  } catch (const ProtocolError& fault) {
    throw Error(ExitCode::checkpoint_unusable,
                fmt::format("{} cannot be read: {}", file.string(), fault.what()));
  }
}

}  // namespace fissura::coupler
