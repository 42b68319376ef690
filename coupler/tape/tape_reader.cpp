// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/tape_reader.hpp"

#include <fmt/format.h>

#include <span>
#include <string>

#include "common/errors.hpp"
#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

bool read_into(std::istream& stream, std::span<std::byte> bytes) {
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return static_cast<std::size_t>(stream.gcount()) == bytes.size();
}

}  // namespace

TapeReader::TapeReader(const std::filesystem::path& file) : file_(file), stream_(file, std::ios::binary) {
  if (!stream_ || !std::filesystem::is_regular_file(file))
    throw Error(ExitCode::precondition, fmt::format("there is no tape {}", file.string()));
  size_ = std::filesystem::file_size(file);
  TapeHeaderBytes bytes{};
  const std::optional<TapeHeader> header =
      read_into(stream_, bytes) ? decode_tape_header(bytes) : std::nullopt;
  if (!header) throw StorageError(fmt::format("{} is no tape: its header is damaged", file.string()));
  header_ = *header;
  offset_ = tape_header_size;
}

std::optional<TapeRecord> TapeReader::next() {
  const std::uint64_t left = size_ - offset_;
  cut_bytes_ = left;
  if (left < record_header_size) return std::nullopt;
  RecordHeaderBytes head{};
  if (!read_into(stream_, head)) throw StorageError(fmt::format("{} cannot be read", file_.string()));
  const std::optional<RecordHeader> header = decode_record_header(head);
  const bool consistent = header && header->bytes / sizeof(std::uint64_t) >= header->frames;
  if (!consistent)
    throw StorageError(
        fmt::format("{}: the header of message {} at byte {} is damaged; what comes after it cannot be found",
                    file_.string(), count_, offset_));
  if (header->bytes > left - record_header_size) return std::nullopt;

  TapeRecord record{count_, offset_, header->direction, header->time, {}, false};
  std::vector<std::uint64_t> lengths(header->frames);
  const auto table = std::as_writable_bytes(std::span(lengths));
  if (!read_into(stream_, table)) throw StorageError(fmt::format("{} cannot be read", file_.string()));
  std::uint32_t sum = crc32(table);
  std::uint64_t rest = header->bytes - table.size();
  for (const std::uint64_t length : lengths) {
    if (length > rest) break;
    rest -= length;
    std::vector<std::byte>& frame = record.frames.emplace_back(length);
    if (!read_into(stream_, frame)) throw StorageError(fmt::format("{} cannot be read", file_.string()));
    sum = crc32(frame, sum);
  }
  record.damaged = rest != 0 || record.frames.size() != lengths.size() || sum != header->checksum;
  offset_ += record_header_size + header->bytes;
  stream_.seekg(static_cast<std::streamoff>(offset_));
  ++count_;
  cut_bytes_ = 0;
  return record;
}

}  // namespace fissura::coupler
