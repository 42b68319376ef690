// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace fissura {

/// CRC-32 (as zlib and gzip compute it) of `bytes`, continuing from `start` (0 for a new sum).
std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t start = 0);

/// SHA-256 of `bytes` as 64 lower-case hexadecimal digits.
std::string sha256(std::span<const std::byte> bytes);

/// SHA-256 of a file's content. Throws StorageError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace fissura
