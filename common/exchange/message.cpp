// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/message.hpp"

#include <fmt/format.h>

#include <cstring>

#include "common/errors.hpp"
#include "common/exchange/value_check.hpp"

namespace fissura {

namespace {

template <typename T>
Array make_array(std::string_view name, const char* dtype, std::string_view unit, std::span<const T> values,
                 std::vector<std::uint64_t> shape) {
  Array array{std::string(name), dtype, std::move(shape), std::string(unit), {}};
  array.bytes.resize(values.size_bytes());
  if (!values.empty()) std::memcpy(array.bytes.data(), values.data(), values.size_bytes());
  return array;
}

template <typename T>
std::vector<T> values_of(const Array& array) {
  std::vector<T> values(array.bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), array.bytes.data(), values.size() * sizeof(T));
  return values;
}

}  // namespace

const char* name(MessageType type) {
  switch (type) {
    case MessageType::hello: return "HELLO";
    case MessageType::welcome: return "WELCOME";
    case MessageType::reject: return "REJECT";
    case MessageType::topology: return "TOPOLOGY";
    case MessageType::insert: return "INSERT";
    case MessageType::acknowledge: return "ACKNOWLEDGE";
    case MessageType::advance: return "ADVANCE";
    case MessageType::pressure: return "PRESSURE";
    case MessageType::response: return "RESPONSE";
    case MessageType::report: return "REPORT";
    case MessageType::fields: return "FIELDS";
    case MessageType::save: return "SAVE";
    case MessageType::state: return "STATE";
    case MessageType::restore: return "RESTORE";
    case MessageType::restored: return "RESTORED";
    case MessageType::finish: return "FINISH";
    case MessageType::bye: return "BYE";
    case MessageType::fail: return "FAIL";
    case MessageType::progress: return "PROGRESS";
  }
  return "UNKNOWN";
}

void Message::add(std::string_view array_name, std::string_view unit, std::span<const double> values) {
  arrays.push_back(make_array(array_name, "float64", unit, values, {values.size()}));
}

void Message::add(std::string_view array_name, std::string_view unit, std::span<const double> values,
                  std::uint64_t rows, std::uint64_t columns) {
  ENSURE(values.size() == rows * columns);
  arrays.push_back(make_array(array_name, "float64", unit, values, {rows, columns}));
}

void Message::add_ids(std::string_view array_name, std::span<const std::uint64_t> values,
                      std::uint64_t columns) {
  ENSURE(columns > 0 && values.size() % columns == 0);
  std::vector<std::uint64_t> shape{values.size() / columns};
  if (columns > 1) shape.push_back(columns);
  arrays.push_back(make_array(array_name, "uint64", "1", values, std::move(shape)));
}

void Message::add_bytes(std::string_view array_name, std::span<const std::byte> values) {
  arrays.push_back(make_array(array_name, "uint8", "1", values, {values.size()}));
}

bool Message::has(std::string_view array_name) const {
  for (const Array& candidate : arrays)
    if (candidate.name == array_name) return true;
  return false;
}

const Array& Message::array(std::string_view array_name, std::string_view dtype) const {
  for (const Array& candidate : arrays) {
    if (candidate.name != array_name) continue;
    if (candidate.dtype != dtype)
      throw ProtocolError(fmt::format("{}: array {} must be {}, found {}", fissura::name(type), array_name, dtype,
                                      candidate.dtype));
    return candidate;
  }
  throw ProtocolError(fmt::format("{}: array {} is missing", fissura::name(type), array_name));
}

std::vector<double> Message::numbers(std::string_view array_name) const {
  std::vector<double> values = values_of<double>(array(array_name, "float64"));
  if (const auto i = first_not_finite(values))
    throw ValueError(fmt::format("{} interval {}: {}[{}] is {} (of {} values)", fissura::name(type), interval,
                                 array_name, *i, values[*i], values.size()));
  return values;
}

std::vector<double> Message::numbers(std::string_view array_name, std::size_t count) const {
  std::vector<double> values = numbers(array_name);
  if (values.size() != count)
    throw ProtocolError(fmt::format("{} interval {}: {} has {} values, expected {}", fissura::name(type), interval,
                                    array_name, values.size(), count));
  return values;
}

std::vector<std::uint64_t> Message::ids(std::string_view array_name) const {
  return values_of<std::uint64_t>(array(array_name, "uint64"));
}

std::vector<std::byte> Message::bytes(std::string_view array_name) const {
  return array(array_name, "uint8").bytes;
}

void Message::throw_missing(std::string_view key) const {
  throw ProtocolError(
      fmt::format("{} interval {}: body entry {} is missing or of another type", fissura::name(type), interval, key));
}

}  // namespace fissura
