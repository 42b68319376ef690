// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/exchange/codec.hpp"

/// Messages as one string of bytes, for fuzzers and for damage by seed: each frame behind its length in two
/// bytes.
namespace fissura::fuzz {

using Frames = std::vector<std::vector<std::byte>>;

/// Frames as long as the bytes last.
Frames frames_of(std::span<const std::byte> bytes);
std::vector<std::byte> bytes_of(const Frames& frames);

Frames frames_of(EncodedMessage encoded);

/// Envelope of the right size, version and checksum for the frames as they are: what a sender that means harm
/// would write. A fuzzer does not guess a CRC.
Frames restamped(Frames frames);

DecodedMessage decode(const Frames& frames);

}  // namespace fissura::fuzz
