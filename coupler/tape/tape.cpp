// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/tape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <span>
#include <string_view>
#include <system_error>

#include "common/hash.hpp"

namespace fissura::coupler {

namespace {

static_assert(std::endian::native == std::endian::little, "tapes are little-endian");

constexpr std::array<char, 8> tape_magic{'F', 'I', 'S', 'T', 'A', 'P', 'E', '1'};
constexpr std::array<char, 4> to_participant_magic{'F', 'I', 'S', '>'};
constexpr std::array<char, 4> to_coupler_magic{'F', 'I', 'S', '<'};

template <typename Bytes, typename... Fields>
Bytes closed(const Fields&... fields) {
  Bytes bytes{};
  std::size_t offset = 0;
  const auto put = [&](const auto& field) {
    std::memcpy(bytes.data() + offset, &field, sizeof(field));
    offset += sizeof(field);
  };
  (put(fields), ...);
  put(crc32(std::span(bytes).first(offset)));
  return bytes;
}

template <typename Bytes, typename... Fields>
bool open(const Bytes& bytes, Fields&... fields) {
  std::size_t offset = 0;
  const auto take = [&](auto& field) {
    std::memcpy(&field, bytes.data() + offset, sizeof(field));
    offset += sizeof(field);
  };
  (take(fields), ...);
  const std::uint32_t found = crc32(std::span(bytes).first(offset));
  std::uint32_t written = 0;
  take(written);
  return found == written;
}

}  // namespace

TapeHeaderBytes encode(const TapeHeader& header) {
  return closed<TapeHeaderBytes>(tape_magic, static_cast<std::uint32_t>(header.role), header.epoch,
                                 header.run, header.started, std::uint32_t{0});
}

RecordHeaderBytes encode(const RecordHeader& header) {
  return closed<RecordHeaderBytes>(
      header.direction == Direction::to_participant ? to_participant_magic : to_coupler_magic, header.frames,
      header.time, header.bytes, header.checksum);
}

std::optional<TapeHeader> decode_tape_header(const TapeHeaderBytes& bytes) {
  TapeHeader header;
  std::array<char, 8> magic{};
  std::uint32_t role = 0, unused = 0;
  if (!open(bytes, magic, role, header.epoch, header.run, header.started, unused)) return std::nullopt;
  if (magic != tape_magic || role >= role_count) return std::nullopt;
  header.role = static_cast<Role>(role);
  return header;
}

std::optional<RecordHeader> decode_record_header(const RecordHeaderBytes& bytes) {
  RecordHeader header;
  std::array<char, 4> magic{};
  if (!open(bytes, magic, header.frames, header.time, header.bytes, header.checksum)) return std::nullopt;
  if (magic != to_participant_magic && magic != to_coupler_magic) return std::nullopt;
  header.direction = magic == to_participant_magic ? Direction::to_participant : Direction::to_coupler;
  return header;
}

std::filesystem::path tape_file(const std::filesystem::path& run_directory, Role role, std::uint32_t epoch) {
  return run_directory / tape_folder_name / fmt::format("{}.{}.tape", name(role), epoch);
}

std::vector<std::uint32_t> taped_epochs(const std::filesystem::path& run_directory, Role role) {
  std::vector<std::uint32_t> epochs;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(run_directory / tape_folder_name, missing)) {
    const std::string file = entry.path().filename().string();
    const std::string begin = fmt::format("{}.", name(role));
    if (!file.starts_with(begin)) continue;
    std::uint32_t epoch = 0;
    const auto read = std::from_chars(file.data() + begin.size(), file.data() + file.size(), epoch);
    if (read.ec == std::errc() && std::string_view(read.ptr) == ".tape") epochs.push_back(epoch);
  }
  std::sort(epochs.begin(), epochs.end());
  return epochs;
}

}  // namespace fissura::coupler
