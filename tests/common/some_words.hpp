// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "common/exchange/protocol_table.hpp"
#include "common/fracture_network/fracture_network.hpp"

namespace fissura::test {

/// The network of one node, then of two.
Insertion insertion_of_revision(std::uint64_t revision);

/// A message that says `word`, complete enough to be acted upon: interval 0; its insertion, and with it all
/// it speaks of, is of `revision`.
Message message_of(Word word, std::uint64_t revision = 0);

}  // namespace fissura::test
