// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "coupler/faults/frame_link.hpp"
#include "coupler/faults/message_fault.hpp"

/// Changes of a message in flight. Each is exact: where the message has not what is to be changed, it stays
/// as it is.
namespace fissura::coupler {

/// The last frame if `frame` is not given. Keeps its first `bytes` bytes, or half of them.
bool truncate(Frames& message, std::optional<std::uint64_t> frame, std::optional<std::uint64_t> bytes);

/// Inverts one bit of a frame, the last one if `frame` is not given; bits count from the lowest of the first
/// byte, and from the beginning again beyond the end.
bool flip(Frames& message, std::optional<std::uint64_t> frame, std::uint64_t bit);

/// Gives the array `field` another number of values, in declaration and bytes; new ones are zero.
bool resize(Frames& message, const std::string& field, std::uint64_t length);

/// Another value in the envelope: `value`, or the old one plus `shift`. A run id has `value` in all its
/// bytes.
bool restamp(Frames& message, StampField stamp, std::optional<std::uint64_t> value, std::int64_t shift);

/// Another value of the float64 array `field`, or of the body entry at the JSON pointer `entry`.
bool poison(Frames& message, const std::string& field, std::uint64_t index, double value);
bool poison(Frames& message, const std::string& entry, double value);

/// Declares the array `field` in another unit.
bool relabel(Frames& message, const std::string& field, const std::string& unit);

/// Fills the last frame up with zeros to `bytes`.
bool oversize(Frames& message, std::uint64_t bytes);

/// One frame of bytes that mean nothing, always the same.
Frames nonsense(std::uint64_t bytes);

}  // namespace fissura::coupler
