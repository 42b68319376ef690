// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "common/errors.hpp"

/// State blobs of a checkpoint: values one after the other, bit for bit, for the same program on the same kind of machine.
namespace fissura {

class ByteWriter {
 public:
  template <typename T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* first = reinterpret_cast<const std::byte*>(&value);
    bytes_.insert(bytes_.end(), first, first + sizeof(T));
  }
  template <typename T>
  void put(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(static_cast<std::uint64_t>(values.size()));
    const auto* first = reinterpret_cast<const std::byte*>(values.data());
    bytes_.insert(bytes_.end(), first, first + values.size() * sizeof(T));
  }
  void put(const std::string& text) { put(std::vector<char>(text.begin(), text.end())); }

  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Reads in the order of writing. Every read beyond the end throws Error(checkpoint_unusable).
class ByteReader {
 public:
  explicit ByteReader(const std::vector<std::byte>& bytes) : bytes_(bytes) {}

  template <typename T>
  void get(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::memcpy(&value, advance(sizeof(T)), sizeof(T));
  }
  template <typename T>
  void get(std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::uint64_t count = 0;
    get(count);
    if (count > (bytes_.size() - position_) / sizeof(T)) refuse();
    values.resize(count);
    if (count > 0) std::memcpy(values.data(), advance(count * sizeof(T)), count * sizeof(T));
  }
  void get(std::string& text) {
    std::vector<char> characters;
    get(characters);
    text.assign(characters.begin(), characters.end());
  }
  /// Throws if anything is left.
  void end() const {
    if (position_ != bytes_.size()) refuse();
  }

 private:
  const std::byte* advance(std::size_t count) {
    if (count > bytes_.size() - position_) refuse();
    const std::byte* here = bytes_.data() + position_;
    position_ += count;
    return here;
  }
  [[noreturn]] static void refuse() {
    throw Error(ExitCode::checkpoint_unusable, "the saved state does not fit this program or this case");
  }

  const std::vector<std::byte>& bytes_;
  std::size_t position_ = 0;
};

}  // namespace fissura
