// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace fissura::coupler {

/// What a run is, known before its first interval.
struct RunDescription {
  std::string run_id;                              ///< hexadecimal
  std::string title;                               ///< of the case
  nlohmann::json effective_case;                   ///< the case in SI, all overrides applied
  std::vector<std::filesystem::path> input_files;  ///< case.toml, short.toml, traces, reference ...
  std::vector<std::string> command_line;
  int threads = 1;                                  ///< of the structure
  std::map<std::string, std::string> participants;  ///< role -> solver name and version
  std::map<std::string, std::string> libraries;     ///< name -> version, beyond what the coupler knows itself
  std::vector<std::string> probes;                  ///< names of the case's probes
};

/// Version and commit of this program, e.g. "0.1.0 1a2b3c".
std::string program_version();

/// SHA-256 of the compact JSON text of `effective_case` (keys sorted); the case hash of run.json.
std::string case_hash(const nlohmann::json& effective_case);

/// The content of run.json: `program`, `version`, `git_commit` ("unknown" outside a repository), `compiler`,
/// `libraries`, `run_id`, `title`, `case_hash`, `inputs` (file name -> SHA-256), `threads`, `command_line`,
/// `participants`, `started` (UTC), `columns` (SHA-256 of columns.json). Of input files only the name is
/// told, never the folder. Throws StorageError if an input file cannot be read.
nlohmann::json run_json(const RunDescription& description);

/// The text of run.json: `content`, closed by its own SHA-256 as entry `sha256`.
std::string sealed_run_text(nlohmann::json content);

/// The content of such a text. Throws StorageError if it is not as it was written.
nlohmann::json opened_run_text(const std::string& text);

}  // namespace fissura::coupler
