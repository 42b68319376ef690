// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

#include "coupler/tape/tape.hpp"

namespace fissura::coupler {

/// One message of a tape.
struct TapeRecord {
  std::uint64_t number = 0;  ///< from 0, all messages of both directions
  std::uint64_t offset = 0;  ///< of its header in the file [bytes]
  Direction direction = Direction::to_participant;
  double time = 0;  ///< [s since `started`]
  Frames frames;
  bool damaged = false;  ///< the frames are not what was written
};

/// Reads a tape from its beginning, also one that is being written.
class TapeReader {
 public:
  /// Throws Error(precondition) if there is no such file, StorageError if it is no tape.
  explicit TapeReader(const std::filesystem::path& file);

  [[nodiscard]] const TapeHeader& header() const { return header_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// The next message; nothing at the end of the last whole one. Throws StorageError naming record and place
  /// if a header is damaged: what stands behind it cannot be found.
  std::optional<TapeRecord> next();

  /// Bytes of a message that is not whole, at the end of a tape whose writer was killed. @pre `next` has
  /// returned nothing
  [[nodiscard]] std::uint64_t cut_bytes() const { return cut_bytes_; }

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
  TapeHeader header_;
  std::uint64_t size_ = 0, offset_ = 0, count_ = 0, cut_bytes_ = 0;
};

}  // namespace fissura::coupler
