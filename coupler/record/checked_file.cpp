// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/checked_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

constexpr std::size_t buffer_size = 1 << 16;

[[noreturn]] void fail(const char* doing, const std::filesystem::path& file) {
  throw StorageError(fmt::format("cannot {} {}: {}", doing, file.string(), std::strerror(errno)));
}

}  // namespace

CheckedFile::CheckedFile(const std::filesystem::path& file)
    : path_(file), descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)) {
  if (descriptor_ < 0) fail("create", path_);
}

CheckedFile::~CheckedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

CheckedFile::CheckedFile(CheckedFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)) {}

void CheckedFile::append(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void CheckedFile::flush() {
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
  if (::fsync(descriptor_) != 0) fail("sync", path_);
}

void sync_to_disk(const std::filesystem::path& file_or_directory) {
  const int descriptor = ::open(file_or_directory.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail("open", file_or_directory);
  const int result = ::fsync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  if (result != 0) fail("sync", file_or_directory);
}

void publish(const std::filesystem::path& part, const std::filesystem::path& file) {
  if (::rename(part.c_str(), file.c_str()) != 0) fail("rename", part);
  sync_to_disk(file.parent_path());
}

void write_whole_file(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path part = file.string() + ".part";
  CheckedFile output(part);
  output.append(text);
  output.sync();
  publish(part, file);
}

}  // namespace fissura::coupler
