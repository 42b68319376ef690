// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

#include "common/fracture_network/fracture_network.hpp"
#include "tests/fuzz/raw_frames.hpp"

/// Messages as they are sent, and as they may arrive.
namespace fissura::bench {

using Random = std::mt19937_64;

/// Uniform in [0, count).
std::size_t below(Random& random, std::size_t count);

struct Sent {
  Message message;
  Stamp stamp;
};

/// PRESSURE, RESPONSE, INSERT or STATE of random content for the network, which has `growth()` to come.
Message random_message(Random& random, const FractureNetwork& network);

/// A spoiled message; `frames` are what arrives.
struct Damaged {
  std::string kind;
  fuzz::Frames frames;
};

/// Spoils `sent`; `earlier` and `later` are sound messages of the same conversation.
Damaged spoil(Random& random, const Sent& earlier, const Sent& sent, const Sent& later);

}  // namespace fissura::bench
