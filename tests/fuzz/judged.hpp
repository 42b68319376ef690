// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/errors.hpp"

/// What every target has in common. A reader may take its input or refuse it with an Error; anything else
/// (another exception, a sanitizer's word, no end) is a finding.
namespace fissura::fuzz {

template <typename Reading>
void take_or_refuse(Reading reading) {
  try {
    reading();
  } catch (const Error&) {  // NOLINT: refusing is right
  }
}

/// Ends the program with the condition, so that the fuzzer keeps the input.
#define MUST_HOLD(condition) ENSURE(condition)

inline std::span<const std::byte> bytes_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const std::byte*>(data), size};
}

inline std::vector<std::byte> copied(const std::uint8_t* data, std::size_t size) {
  const auto bytes = bytes_of(data, size);
  return {bytes.begin(), bytes.end()};
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace fissura::fuzz
