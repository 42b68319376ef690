// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/errors.hpp"

/// State blobs of a checkpoint: values one after the other, bit for bit, for the same program on the same
/// kind of machine.
///
/// A structure with padding, with enumerations or with members of variable length is taken apart by a
/// function beside it,
///   auto parts(EitherOf<Face> auto& face) { return std::tie(face.length, face.kind); }
/// so that equal values give equal bytes and nothing is read that its type forbids. An enumeration names its
/// greatest value:
///   constexpr Kind last_of(Kind) { return Kind::natural; }
namespace fissura {

/// `Some` is T or const T.
template <typename Some, typename T>
concept EitherOf = std::same_as<std::remove_const_t<Some>, T>;

template <typename T>
concept HasParts = requires(T& value) {
  parts(value);
};

/// Values whose bytes are stored as they are.
template <typename T>
concept Flat =
    std::is_trivially_copyable_v<T> && !HasParts<T> && !std::same_as<T, bool> && !std::is_enum_v<T>;

class ByteWriter {
 public:
  template <Flat T>
  void put(const T& value) {
    append(&value, sizeof(T));
  }
  void put(bool value) { put(static_cast<std::uint8_t>(value)); }
  template <typename T>
  requires std::is_enum_v<T>
  void put(T value) { put(static_cast<std::underlying_type_t<T>>(value)); }
  template <HasParts T>
  void put(const T& value) {
    std::apply([this](const auto&... part) { (put(part), ...); }, parts(value));
  }
  template <typename T>
  void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <typename T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    if constexpr (Flat<T>)
      append(values.data(), values.size() * sizeof(T));
    else
      for (const T& value : values) put(value);
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }

  /// Everything so far.
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }

  std::vector<std::byte> bytes_;
};

/// Reads in the order of writing. Throws Error(checkpoint_unusable) beyond the end, and for a truth value or
/// an enumeration that has no such value.
class ByteReader {
 public:
  /// `bytes` must outlive this.
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <Flat T>
  void get(T& value) {
    std::memcpy(&value, advance(sizeof(T)), sizeof(T));
  }
  void get(bool& value) {
    std::uint8_t found = 0;
    get(found);
    require(found <= 1);
    value = found == 1;
  }
  template <typename T>
  requires std::is_enum_v<T>
  void get(T& value) {
    std::underlying_type_t<T> found{};
    get(found);
    if constexpr (requires { last_of(T{}); })
      require(std::cmp_greater_equal(found, 0) && found <= static_cast<std::underlying_type_t<T>>(last_of(T{})));
    value = static_cast<T>(found);
  }
  template <HasParts T>
  void get(T& value) {
    std::apply([this](auto&... part) { (get(part), ...); }, parts(value));
  }
  template <typename T>
  void get(std::optional<T>& value) {
    bool present = false;
    get(present);
    value.reset();
    if (present) get(value.emplace());
  }
  template <typename T>
  void get(std::vector<T>& values) {
    std::uint64_t count = 0;
    get(count);
    values.clear();
    if constexpr (Flat<T>) {
      require(count <= left() / sizeof(T));
      values.resize(count);
      if (count > 0) std::memcpy(values.data(), advance(count * sizeof(T)), count * sizeof(T));
    } else {
      // A count that lies runs into the end before it takes much memory.
      for (std::uint64_t k = 0; k < count; ++k) get(values.emplace_back());
    }
  }
  void get(std::string& text) {
    std::uint64_t count = 0;
    get(count);
    require(count <= left());
    text.assign(reinterpret_cast<const char*>(advance(count)), count);
  }

  /// What has not been read.
  [[nodiscard]] std::span<const std::byte> rest() const { return bytes_.subspan(position_); }

  /// Throws unless what was read can be true.
  static void require(bool can_be) {
    if (!can_be)
      throw Error(ExitCode::checkpoint_unusable, "the saved state does not fit this program or this case");
  }
  /// Throws if anything is left.
  void end() const { require(left() == 0); }

 private:
  [[nodiscard]] std::size_t left() const { return bytes_.size() - position_; }
  const std::byte* advance(std::size_t count) {
    require(count <= left());
    const std::byte* here = bytes_.data() + position_;
    position_ += count;
    return here;
  }

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

}  // namespace fissura
