// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "common/exchange/message.hpp"
#include "common/exchange/role.hpp"
#include "coupler/faults/frame_link.hpp"
#include "coupler/faults/message_fault.hpp"

/// A tape holds every message between the coupler and one participant in one epoch of a run, as it was on the
/// wire: RUN/tape/ROLE.EPOCH.tape. Layout in docs/results.md, section "Tapes".
namespace fissura::coupler {

inline constexpr const char* tape_folder_name = "tape";

/// What a tape begins with.
struct TapeHeader {
  Role role = Role::network;
  std::uint32_t epoch = 0;  ///< how often the run has been resumed
  RunId run{};
  double started = 0;  ///< UTC, seconds since 1970; zero of the times on both tapes of this epoch

  bool operator==(const TapeHeader&) const = default;
};

/// What stands before the frames of each message.
struct RecordHeader {
  Direction direction = Direction::to_participant;
  std::uint32_t frames = 0;    ///< how many
  double time = 0;             ///< wall, when it was sent or had come [s since `started`]
  std::uint64_t bytes = 0;     ///< of what follows: lengths of the frames, frames
  std::uint32_t checksum = 0;  ///< CRC-32 of what follows

  bool operator==(const RecordHeader&) const = default;
};

inline constexpr std::size_t tape_header_size = 48;
inline constexpr std::size_t record_header_size = 32;
using TapeHeaderBytes = std::array<std::byte, tape_header_size>;
using RecordHeaderBytes = std::array<std::byte, record_header_size>;

/// With a CRC-32 of their own at the end.
TapeHeaderBytes encode(const TapeHeader& header);
RecordHeaderBytes encode(const RecordHeader& header);
/// Nothing if the bytes are not what `encode` gives.
std::optional<TapeHeader> decode_tape_header(const TapeHeaderBytes& bytes);
std::optional<RecordHeader> decode_record_header(const RecordHeaderBytes& bytes);

/// Where the tape of a run directory is, or would be.
std::filesystem::path tape_file(const std::filesystem::path& run_directory, Role role, std::uint32_t epoch);

/// Epochs of which the run has a tape of `role`, ascending.
std::vector<std::uint32_t> taped_epochs(const std::filesystem::path& run_directory, Role role);

}  // namespace fissura::coupler
