// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "common/exchange/message.hpp"

namespace fissura::coupler {

/// An entry of a body that may differ between equal runs.
struct MeaninglessDifference {
  MessageType type = MessageType::hello;
  std::string_view entry;  ///< JSON pointer; `*` stands for any characters but '/'
  std::string_view reason;
};

/// All of them: everything else is compared bit for bit.
std::span<const MeaninglessDifference> meaningless_differences();

/// Whether `entry` (JSON pointer) of a message of this type is one of them.
bool is_meaningless(MessageType type, std::string_view entry);

}  // namespace fissura::coupler
