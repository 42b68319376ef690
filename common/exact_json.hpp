// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>
#include <vector>

/// Numbers of JSON without loss. The library's own conversion makes 2 of 2.7, a large number of -1, and anything of 1e30.
namespace fissura {

/// `value` as a whole number of type T. Throws nlohmann::json::type_error if it is none, or none of the range of T.
template <std::integral T>
T whole_number(const nlohmann::json& value) {
  if (value.is_number_unsigned()) {
    if (const auto number = value.get<std::uint64_t>(); std::in_range<T>(number)) return static_cast<T>(number);
  } else if (value.is_number_integer()) {
    if (const auto number = value.get<std::int64_t>(); std::in_range<T>(number)) return static_cast<T>(number);
  }
  throw nlohmann::json::type_error::create(302, "type must be a whole number in range, but is another", &value);
}

template <typename T>
constexpr bool is_list = false;
template <typename T>
constexpr bool is_list<std::vector<T>> = true;

/// `value` as T: whole numbers, alone or in a list, without loss, everything else as the library converts it. Throws
/// nlohmann::json::exception.
template <typename T>
T exactly(const nlohmann::json& value) {
  if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    return whole_number<T>(value);
  } else if constexpr (is_list<T>) {
    T list;
    for (const nlohmann::json& entry : value.get_ref<const nlohmann::json::array_t&>())
      list.push_back(exactly<typename T::value_type>(entry));
    return list;
  } else {
    return value.get<T>();
  }
}

}  // namespace fissura
