// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/case/case.hpp"

/// The case as participants receive it: SI numbers, keys exactly the member names of case.hpp, enumerations
/// as the words of case.toml.
namespace fissura {

/// dump() of the result is a canonical text of the effective case: equal cases give equal bytes.
nlohmann::json case_to_json(const Case& value);

/// Throws ProtocolError if a key is missing or a value has the wrong type. Keys that are not known are
/// skipped.
Case case_from_json(const nlohmann::json& json);

}  // namespace fissura
