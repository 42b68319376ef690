// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupler/checkpoint/checkpoint_store.hpp"

namespace fissura::coupler::sample {

Provenance provenance();

/// After `interval`, with states of three parts that differ from interval to interval.
Checkpoint checkpoint(std::uint64_t interval);

std::vector<std::byte> bytes_of(const std::string& text);

}  // namespace fissura::coupler::sample
