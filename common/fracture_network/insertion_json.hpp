// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "common/fracture_network/fracture_network.hpp"

namespace fissura {

/// The `insertion` object of docs/protocol.md, section 3. Coordinates and lengths keep every bit.
nlohmann::json insertion_to_json(const Insertion& insertion);

/// Throws ProtocolError, naming the entry, if one is missing or of another type.
Insertion insertion_from_json(const nlohmann::json& json);

}  // namespace fissura
