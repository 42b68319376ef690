// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace fissura::coupler {

/// How far a growing file had come, and the CRC-32 of everything up to there.
struct FileMark {
  std::uint64_t bytes = 0;
  std::uint32_t crc32 = 0;

  bool operator==(const FileMark&) const = default;
};

/// A text file that is written from its beginning to its end and whose every write is checked. All functions
/// throw StorageError with the file, the call that failed and the system's reason.
class CheckedFile {
 public:
  /// Creates `file`, or empties it.
  explicit CheckedFile(const std::filesystem::path& file);
  /// Goes on with `file` at `mark`: what stands behind it is cut off, and the disk has that. @pre check_mark
  CheckedFile(const std::filesystem::path& file, const FileMark& mark);
  /// Closes without a word: what was not flushed is lost.
  ~CheckedFile();
  CheckedFile(CheckedFile&& other) noexcept;
  CheckedFile& operator=(CheckedFile&& other) noexcept;

  /// Appends to the buffer, which is handed to the system when it is large.
  void append(std::string_view text);
  /// Hands the buffer to the system.
  void flush();
  /// Flushes and waits until the disk has it (fsync).
  void sync();

  /// Of everything appended.
  [[nodiscard]] const FileMark& mark() const { return mark_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::string buffer_;
  FileMark mark_;
};

/// Throws Error(checkpoint_unusable), naming the file, if `file` cannot be read, is shorter than `mark`, or
/// is another up to there.
void check_mark(const std::filesystem::path& file, const FileMark& mark);

/// Waits until the disk has the content of `file` or the entries of a directory (fsync).
void sync_to_disk(const std::filesystem::path& file_or_directory);

/// Renames `part` to `file` in the same directory and makes that durable. A reader sees the old file or the
/// whole new one. @pre `part` has been synced
void publish(const std::filesystem::path& part, const std::filesystem::path& file);

/// Writes `text` to `file`.part, syncs it and publishes it as `file`. If that fails no part stays behind.
void write_whole_file(const std::filesystem::path& file, std::string_view text);

/// The content of `file`. Throws StorageError.
std::string read_whole_file(const std::filesystem::path& file);

}  // namespace fissura::coupler
