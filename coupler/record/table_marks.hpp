// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "common/byte_archive.hpp"
#include "coupler/record/checked_file.hpp"

/// How far the growing files of a run had come at a checkpoint.
namespace fissura::coupler {

/// By path from the run directory, e.g. "segments/index.jsonl". A file that is not there had not begun.
using TableMarks = std::map<std::string, FileMark>;

void put(ByteWriter& archive, const TableMarks& marks);
/// Throws Error(checkpoint_unusable).
TableMarks get_marks(ByteReader& archive);

/// Throws Error(checkpoint_unusable), naming the file, unless every file reaches its mark and is up to there
/// as it was written. Changes nothing.
void check_marks(const std::filesystem::path& run_directory, const TableMarks& marks);

/// The file `name` of a run, cut off at its mark, to be gone on with. Nothing if it had not begun: then it is
/// removed. @pre check_marks. Throws StorageError.
std::optional<CheckedFile> at_mark(const std::filesystem::path& run_directory, const std::string& name,
                                   const TableMarks& marks);

/// Removes `file` if it is there. Throws StorageError.
void remove_file(const std::filesystem::path& file);

}  // namespace fissura::coupler
