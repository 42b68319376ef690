// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

/// What can be told of a table or log without knowing how it was written. Each function returns what it has
/// looked at, in a few words, and throws Error, naming the line, if something is wrong. A last line without
/// its end is passed over: a run that is going on may still be writing it.
namespace fissura::coupler {

/// ledger.csv: intervals and times follow each other, and every line balances, injected + in_place + found +
/// reset - in_fractures - leaked = residual to rounding, its relative residual within what the run allows.
std::string check_ledger(const std::filesystem::path& file);

/// history.csv: numbers throughout, intervals and times follow each other.
std::string check_history(const std::filesystem::path& file);

/// log.jsonl: every line is a JSON object.
std::string check_log(const std::filesystem::path& file);

/// catalogue.csv: every line is an event.
std::string check_catalogue(const std::filesystem::path& file);

/// An HDF5 file: every array can be read, its checksum fits.
std::string check_arrays(const std::filesystem::path& file);

/// A tape (coupler/tape/tape.hpp): every message is as it was written; what is cut off at the end is told.
std::string check_tape(const std::filesystem::path& file);

}  // namespace fissura::coupler
