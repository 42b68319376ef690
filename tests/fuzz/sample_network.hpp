// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"
#include "common/exchange/message.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "common/state_blob.hpp"

/// A short fracture and what is said about it, for seeds and as the state that a message meets.
namespace fissura::fuzz {

/// A well that pumps water, then gel, into a fracture of unit thickness.
Case water_case();

/// Nodes 1 ... `nodes` in a line, the perforation at the third.  @pre nodes >= 3
Insertion first_insertion(std::uint64_t nodes);

/// One node more at the end; the second revision of a network of `nodes`.
Insertion growth(std::uint64_t nodes);

FractureNetwork network_of(const Insertion& insertion);

/// Pressures and flags that a coupler takes from participants of `network`.
PressureRange pressure_range();
Message pressure_message(const FractureNetwork& network);
Message response_message(const FractureNetwork& network);
/// From `begin` to `end` [s], for the flow solver.
Message advance_message(const FractureNetwork& network, double begin, double end);

/// These bytes as the state inside a blob of this owner, under a right checksum: a reader then looks at them.
std::vector<std::byte> as_state_of(const StateOwner& owner, std::span<const std::byte> inside);

}  // namespace fissura::fuzz
