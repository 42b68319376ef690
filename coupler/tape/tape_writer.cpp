// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/tape_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <utility>

#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

[[noreturn]] void fail(const char* doing, const std::filesystem::path& file, int reason) {
  throw StorageError(fmt::format("cannot {} {}: {}", doing, file.string(), std::strerror(reason)));
}

}  // namespace

TapeWriter::TapeWriter(std::filesystem::path file, const TapeHeader& header)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)) {
  if (descriptor_ < 0) fail("create", file_, errno);
  const TapeHeaderBytes bytes = encode(header);
  const std::span<const std::byte> piece(bytes);
  put({&piece, 1});
}

TapeWriter::~TapeWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

TapeWriter::TapeWriter(TapeWriter&& other) noexcept
    : file_(std::move(other.file_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      failed_(other.failed_) {}

void TapeWriter::write(Direction direction, double time, FrameViews frames) {
  if (failed_) return;
  std::vector<std::uint64_t> lengths;
  for (const auto& frame : frames) lengths.push_back(frame.size());
  const auto table = std::as_bytes(std::span(lengths));
  RecordHeader header{direction, static_cast<std::uint32_t>(frames.size()), time, table.size(), crc32(table)};
  for (const auto& frame : frames) {
    header.bytes += frame.size();
    header.checksum = crc32(frame, header.checksum);
  }
  const RecordHeaderBytes head = encode(header);
  std::vector<std::span<const std::byte>> pieces{head, table};
  pieces.insert(pieces.end(), frames.begin(), frames.end());
  put(pieces);
}

void TapeWriter::put(FrameViews pieces) {
  std::vector<iovec> left;
  for (const auto& piece : pieces)
    if (!piece.empty()) left.push_back({const_cast<std::byte*>(piece.data()), piece.size()});
  std::size_t first = 0;
  while (first < left.size()) {
    const int planned = injected_error(StorageCall::write);
    const auto count = static_cast<int>(std::min<std::size_t>(left.size() - first, IOV_MAX));
    const ssize_t written = planned != 0 ? -1 : ::writev(descriptor_, &left[first], count);
    if (written < 0 && planned == 0 && errno == EINTR) continue;
    if (written < 0) {
      failed_ = true;
      fail("write", file_, planned != 0 ? planned : errno);
    }
    auto done = static_cast<std::size_t>(written);
    for (; first < left.size() && done >= left[first].iov_len; ++first) done -= left[first].iov_len;
    if (first == left.size()) break;
    left[first].iov_base = static_cast<std::byte*>(left[first].iov_base) + done;
    left[first].iov_len -= done;
  }
}

void TapeWriter::sync() {
  if (failed_) return;
  const int planned = injected_error(StorageCall::sync);
  if (planned != 0 || ::fsync(descriptor_) != 0) fail("sync", file_, planned != 0 ? planned : errno);
}

}  // namespace fissura::coupler
