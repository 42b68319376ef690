// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/checked_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

constexpr std::size_t buffer_size = 1 << 16;

[[noreturn]] void fail(const char* doing, const std::filesystem::path& file) {
  throw StorageError(fmt::format("cannot {} {}: {}", doing, file.string(), std::strerror(errno)));
}

/// The call about to be made fails if a fault plan says so.
void obey_fault_plan(StorageCall call, const char* doing, const std::filesystem::path& file) {
  if (const int error = injected_error(call)) {
    errno = error;
    fail(doing, file);
  }
}

}  // namespace

CheckedFile::CheckedFile(const std::filesystem::path& file)
    : path_(file), descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)) {
  if (descriptor_ < 0) fail("create", path_);
}

CheckedFile::CheckedFile(const std::filesystem::path& file, const FileMark& mark)
    : path_(file), descriptor_(::open(file.c_str(), O_WRONLY | O_CLOEXEC)), mark_(mark) {
  if (descriptor_ < 0) fail("open", path_);
  const auto end = static_cast<off_t>(mark.bytes);
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) != end) {
    const int reason = errno;
    ::close(std::exchange(descriptor_, -1));
    errno = reason;
    fail("shorten", path_);
  }
  try {
    sync();
  } catch (...) {
    ::close(std::exchange(descriptor_, -1));
    throw;
  }
}

CheckedFile::~CheckedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

CheckedFile::CheckedFile(CheckedFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)),
      mark_(other.mark_) {}

CheckedFile& CheckedFile::operator=(CheckedFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(buffer_, other.buffer_);
  std::swap(mark_, other.mark_);
  return *this;
}

void CheckedFile::append(std::string_view text) {
  buffer_ += text;
  mark_.bytes += text.size();
  mark_.crc32 = crc32(std::as_bytes(std::span(text)), mark_.crc32);
  if (buffer_.size() >= buffer_size) flush();
}

void CheckedFile::flush() {
  obey_fault_plan(StorageCall::write, "write", path_);
  std::size_t written = 0;
  while (written < buffer_.size()) {
    const ssize_t count = ::write(descriptor_, buffer_.data() + written, buffer_.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int reason = errno;
      buffer_.erase(0, written);
      errno = reason;
      fail("write", path_);
    }
    written += static_cast<std::size_t>(count);
  }
  buffer_.clear();
}

void CheckedFile::sync() {
  flush();
  obey_fault_plan(StorageCall::sync, "sync", path_);
  if (::fsync(descriptor_) != 0) fail("sync", path_);
}

void check_mark(const std::filesystem::path& file, const FileMark& mark) {
  const auto refuse = [&](const std::string& what) {
    throw Error(ExitCode::checkpoint_unusable, fmt::format("{} {}", file.string(), what));
  };
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse("cannot be read");
  std::vector<char> block(1 << 16);
  FileMark found;
  while (found.bytes < mark.bytes) {
    stream.read(block.data(), static_cast<std::streamsize>(
                                  std::min<std::uint64_t>(block.size(), mark.bytes - found.bytes)));
    const auto count = static_cast<std::size_t>(stream.gcount());
    if (count == 0) refuse(fmt::format("has {} bytes, {} were written", found.bytes, mark.bytes));
    found.bytes += count;
    found.crc32 = crc32(std::as_bytes(std::span(block).first(count)), found.crc32);
  }
  if (found != mark) refuse("is not what was written: its checksum differs");
}

void sync_to_disk(const std::filesystem::path& file_or_directory) {
  obey_fault_plan(StorageCall::sync, "sync", file_or_directory);
  const int descriptor = ::open(file_or_directory.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail("open", file_or_directory);
  const int result = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  if (result != 0) fail("sync", file_or_directory);
}

void publish(const std::filesystem::path& part, const std::filesystem::path& file) {
  obey_fault_plan(StorageCall::rename, "rename", part);
  if (::rename(part.c_str(), file.c_str()) != 0) fail("rename", part);
  sync_to_disk(file.parent_path());
}

void write_whole_file(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path part = file.string() + ".part";
  try {
    CheckedFile output(part);
    output.append(text);
    output.sync();
    publish(part, file);
  } catch (const StorageError&) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
}

std::string read_whole_file(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail("open", file);
  std::string text;
  std::vector<char> block(1 << 16);
  for (;;) {
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const int reason = errno;
      ::close(descriptor);
      errno = reason;
      if (count < 0) fail("read", file);
      return text;
    }
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace fissura::coupler
