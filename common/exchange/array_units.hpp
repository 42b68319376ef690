// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/exchange/message.hpp"

/// The units of docs/protocol.md. Both sides look here at every message that arrives, before a number of it
/// is read.
namespace fissura {

/// The SI unit that values of the array `array_name` have in every message; nothing for a name that the
/// protocol does not know (further fields of a solver).
std::optional<std::string_view> unit_of_array(std::string_view array_name);

/// The first array of `message` that declares another unit than the protocol gives its name, as a sentence
/// with field, expected and found; nothing if there is none.
std::optional<std::string> wrong_unit(const Message& message);

}  // namespace fissura
