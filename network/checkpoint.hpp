// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "network/state.hpp"

namespace fissura::network {

/// Everything that the case does not say: how the network came to be, and the state. CBOR (RFC 8949) with a
/// version tag; numbers come back bit for bit.
struct Checkpoint {
  std::vector<Insertion> history;  ///< from revision 0 on
  State state;
};

std::vector<std::byte> checkpoint_to_bytes(const Checkpoint& checkpoint);

/// Throws Error(checkpoint_unusable) if the bytes are damaged or of another version.
Checkpoint checkpoint_from_bytes(std::span<const std::byte> bytes);

}  // namespace fissura::network
