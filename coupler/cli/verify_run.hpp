// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fissura::coupler {

enum class Soundness {
  sound,
  noted,    ///< nothing is wrong, but the reader should know
  damaged,  ///< another than what was written, or missing
};

/// One thing that was looked at.
struct Finding {
  std::string name;  ///< a file, from the run directory, or a group of files
  Soundness soundness = Soundness::sound;
  std::string text;            ///< what was compared, or what is wrong
  bool of_checkpoint = false;  ///< not of a result
};

/// Compares every file of a run with what was written: index and segments with their checksums, files of a
/// finished run with SHA256SUMS, tables with the marks of the newest whole checkpoint, checkpoints with their
/// manifests; reads every line of ledger, history, catalogue and log, and checks that the ledger balances. A
/// damaged segment is read array by array, so that those are named that are lost. Each file is read once.
/// Only reads; the run may be going on, may have failed or have been killed. Throws Error(precondition) if
/// there is no run, StorageError if the directory cannot be read.
std::vector<Finding> verify_run(const std::filesystem::path& run_directory);

}  // namespace fissura::coupler
