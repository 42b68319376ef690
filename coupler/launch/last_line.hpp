// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// Name of the exit code of a run: those of errors.hpp, and HANGUP for 129 (SIGHUP).
std::string name_of_code(int exit_code);

/// Interval of the newest checkpoint that stands in the run directory; nothing without any. Whether it is
/// whole is only known once it is read.
std::optional<std::uint64_t> newest_checkpoint(const std::filesystem::path& run_directory);

/// "interval 12", or "the beginning" without a checkpoint.
std::string place(const std::optional<std::uint64_t>& checkpoint);

/// Whether `coupler resume` can help after this exit code: not where the case, the command line, the machine
/// or the keys must be mended first, nor after a run that is complete.
bool can_resume_after(int exit_code);

/// What to type, e.g. "coupler resume runs/kgd"; in quotes where a shell needs them.
std::string resume_command(const std::filesystem::path& run_directory);

/// coupler: CODE-NAME who interval=K phase=P: sentence. Resume: coupler resume RUN (from interval N)
std::string last_line(const RunFailure& failure, const std::filesystem::path& run_directory,
                      const std::optional<std::uint64_t>& checkpoint);

/// The line of a failure before there is a run directory: without a way to resume.
std::string last_line(const RunFailure& failure);

}  // namespace fissura::coupler
