// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

/// SHA256SUMS of a finished run: what `sha256sum --check SHA256SUMS` reads.
namespace fissura::coupler {

/// SHA-256 by path from the run directory.
using Checksums = std::map<std::string, std::string>;

/// Writes SHA256SUMS over all result files of `run_directory`. `known` are the hashes of files as they were
/// written, which are entered as they are: a file damaged since must not get a fitting hash. Left out is what
/// is no result (lock, status, checkpoints, superseded segments, reports of the supervisor, pages made from
/// the results) and files that are not ours. Throws StorageError.
void write_checksums(const std::filesystem::path& run_directory, const Checksums& known);

/// Throws StorageError if the file cannot be read or a line is not of coreutils' form.
Checksums read_checksums(const std::filesystem::path& file);

}  // namespace fissura::coupler
