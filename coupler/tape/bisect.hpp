// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coupler/tape/tape.hpp"

namespace fissura::coupler {

/// Where two tapes of the same role part.
struct Parting {
  enum class How {
    differs,  ///< a message says something else
    ends      ///< one tape has a message where the other has ended
  };
  How how = How::differs;
  Direction direction = Direction::to_participant;
  double time = 0;       ///< on the first tape, of this message or the last one [s]
  std::string sentence;  ///< lines: message, value, both sides
};

/// Two tapes of one role, message by message. PROGRESS, and checkpoints that only one of the runs kept, are
/// left out: both depend on the clock.
struct TapeComparison {
  Role role = Role::network;
  std::uint64_t identical = 0;  ///< messages before they part
  std::uint64_t interval = 0;   ///< the greatest of an identical one
  std::optional<Parting> parting;
};

/// Throws Error(precondition) if there is no such tape, StorageError naming the place if one is damaged.
TapeComparison compare_tapes(const std::filesystem::path& first, const std::filesystem::path& second);

/// Which of the comparisons, of one role each, parts first by the clock of the first run, and who said it:
/// the participant answered differently to the same words, or it was told something else. Lines.
std::string verdict_of(const std::vector<TapeComparison>& comparisons);

}  // namespace fissura::coupler
