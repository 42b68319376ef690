// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/exchange/envelope.hpp"
#include "coupler/faults/frame_link.hpp"

namespace fissura::coupler {

/// The first thing in which two messages differ.
struct MessageDifference {
  std::string where;          ///< "pressure[12]", "source_moment[3, 1]", "/ledger/leaked", "type", ...
  std::string first, second;  ///< both values, with all digits
  std::optional<std::uint64_t> ulps;  ///< units in the last place between two numbers
  double distance = 0;                ///< magnitude of their difference
  std::string array;                  ///< name of the array it is in; empty if it is in none
  std::uint64_t row = 0;              ///< in that array
  std::uint64_t values = 1;           ///< how many values of the array differ
  std::size_t places = 1;             ///< in how many arrays and entries the messages differ
};

/// Compares type, interval, revision, then arrays in their order, then what else the bodies say, bit for bit,
/// but for meaningless_differences. Sequence, run and epoch are not looked at. Nothing if they are equal.
std::optional<MessageDifference> difference(const Frames& first, const Frames& second);

/// What the two sides of a difference are called.
struct Sides {
  std::string first, second;
};

/// In three lines or four, indented: where (and whose: `place` may be empty), both values, how much differs.
std::string in_words(const MessageDifference& difference, const std::string& place, const Sides& sides);

/// "PRESSURE of interval 17".
std::string title_of(const Frames& message);

/// The envelope of a message; one of FAIL with zeros if there is none.
Envelope envelope_of(const Frames& message);

/// How many doubles lie between two, and one more; 0 for equal bits.
std::uint64_t ulps_between(double first, double second);

}  // namespace fissura::coupler
