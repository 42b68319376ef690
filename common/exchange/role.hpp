// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace fissura {

/// A participant's part in the trio.
enum class Role : std::uint8_t { structure, network };
inline constexpr std::size_t role_count = 2;

/// "structure" or "network".
constexpr const char* name(Role role) {
  return role == Role::structure ? "structure" : "network";
}

}  // namespace fissura
