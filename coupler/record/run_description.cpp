// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/run_description.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/history.hpp"

namespace fissura::coupler {

namespace {

std::map<std::string, std::string> all_libraries(const std::map<std::string, std::string>& told) {
  std::map<std::string, std::string> libraries{
      {"HDF5", hdf5_version()},
      {"libzmq", FISSURA_ZEROMQ_VERSION},
      {"CGAL", FISSURA_CGAL_VERSION},
      {"Eigen", FISSURA_EIGEN_VERSION},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
  };
  for (const auto& [library, version] : told) libraries[library] = version;
  return libraries;
}

constexpr const char* seal = "sha256";

std::string hash_of(const std::string& text) {
  return sha256(std::as_bytes(std::span(text)));
}

}  // namespace

std::string program_version() {
  return fmt::format("{} {}", FISSURA_VERSION, FISSURA_GIT_COMMIT);
}

std::string case_hash(const nlohmann::json& effective_case) {
  return hash_of(effective_case.dump());
}

nlohmann::json run_json(const RunDescription& description) {
  nlohmann::json inputs = nlohmann::json::object();
  for (const auto& file : description.input_files) inputs[file.filename().string()] = sha256_of_file(file);
  return {
      {"program", "fissura"},
      {"version", FISSURA_VERSION},
      {"git_commit", FISSURA_GIT_COMMIT},
      {"compiler", FISSURA_COMPILER},
      {"libraries", all_libraries(description.libraries)},
      {"run_id", description.run_id},
      {"title", description.title},
      {"case_hash", case_hash(description.effective_case)},
      {"inputs", inputs},
      {"threads", description.threads},
      {"command_line", description.command_line},
      {"participants", description.participants},
      {"started", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
      {"columns", hash_of(columns_json())},
  };
}

std::string sealed_run_text(nlohmann::json content) {
  content[seal] = hash_of(content.dump());
  return content.dump(2) + "\n";
}

nlohmann::json opened_run_text(const std::string& text) {
  nlohmann::json content;
  try {
    content = nlohmann::json::parse(text);
    content.erase(seal);
  } catch (const nlohmann::json::exception& fault) {
    throw StorageError(fmt::format("run.json cannot be read: {}", fault.what()));
  }
  if (sealed_run_text(content) != text) throw StorageError("its SHA-256 is not the one it closes with");
  return content;
}

}  // namespace fissura::coupler
