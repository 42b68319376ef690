// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/exact_json.hpp"

/// What travels between coupler and participants; the layout in bytes is docs/protocol.md.
namespace fissura {

enum class MessageType : std::uint16_t {
  // handshake
  hello = 1,
  welcome = 2,
  reject = 3,
  // topology
  topology = 10,
  insert = 11,
  acknowledge = 12,
  // coupling interval
  advance = 20,
  pressure = 21,
  response = 22,
  // output
  report = 30,
  fields = 31,
  // checkpoint
  save = 40,
  state = 41,
  restore = 42,
  restored = 43,
  // end
  finish = 50,
  bye = 51,
  // at any time
  fail = 60,
  progress = 61
};

/// "ADVANCE", "PRESSURE", ...; "UNKNOWN" for a number that is not in the enumeration.
const char* name(MessageType type);

/// Identity of one run: 16 random bytes.
using RunId = std::array<std::uint8_t, 16>;

/// A named array of a message: float64, int64, uint64 or uint8 values with shape and unit.
struct Array {
  std::string name;
  std::string dtype;                 ///< "float64", "int64", "uint64" or "uint8"
  std::vector<std::uint64_t> shape;  ///< row-major
  std::string unit;                  ///< SI, e.g. "Pa"; "1" without dimension
  std::vector<std::byte> bytes;      ///< little-endian values
};

/// One message without its envelope's bookkeeping (run, epoch, sequence, checksum: see envelope.hpp).
class Message {
 public:
  Message() = default;
  explicit Message(MessageType message_type) : type(message_type) {}

  MessageType type = MessageType::fail;
  std::uint64_t interval = 0;  ///< coupling index the message belongs to
  std::uint64_t revision = 0;  ///< topology revision its arrays are made for
  nlohmann::json body = nlohmann::json::object();
  std::vector<Array> arrays;

  /// Appends a one-dimensional float64 array.
  void add(std::string_view array_name, std::string_view unit, std::span<const double> values);
  /// Appends a float64 array of `rows` x `columns`, row-major. @pre values.size() == rows * columns
  void add(std::string_view array_name, std::string_view unit, std::span<const double> values,
           std::uint64_t rows, std::uint64_t columns);
  void add_ids(std::string_view array_name, std::span<const std::uint64_t> values,
               std::uint64_t columns = 1);
  void add_bytes(std::string_view array_name, std::span<const std::byte> values);

  /// The float64 array `array_name`. Throws ProtocolError if it is missing, of another type, or (with `count`) of
  /// another length; ValueError if a value is not finite.
  [[nodiscard]] std::vector<double> numbers(std::string_view array_name) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view array_name, std::size_t count) const;
  /// The uint64 array, with the same checks.
  [[nodiscard]] std::vector<std::uint64_t> ids(std::string_view array_name) const;
  [[nodiscard]] std::vector<std::byte> bytes(std::string_view array_name) const;
  [[nodiscard]] bool has(std::string_view array_name) const;

  /// Body entry `key` converted to T. Throws ProtocolError if it is missing or of another type.
  template <typename T>
  [[nodiscard]] T value(std::string_view key) const {
    try {
      return exactly<T>(body.at(std::string(key)));
    } catch (const nlohmann::json::exception&) {
      throw_missing(key);
    }
  }

 private:
  [[noreturn]] void throw_missing(std::string_view key) const;
  [[nodiscard]] const Array& array(std::string_view array_name, std::string_view dtype) const;
};

}  // namespace fissura
