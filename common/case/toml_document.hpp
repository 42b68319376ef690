// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/case/source_value.hpp"

/// The only door to toml++: TOML text becomes a SourceValue. `${NAME}` in a text value is replaced by the
/// environment variable of that name.
namespace fissura::input {

/// Reads a TOML file. Adds to `faults`, and returns what could be read, if it is missing, not a regular file,
/// too long, not UTF-8 or not TOML, nested too deeply, or names an environment variable that is not set.
SourceValue read_toml(const std::filesystem::path& file, FaultList& faults);

/// The same for text at hand; `name` stands for the file in positions.
SourceValue parse_toml(std::string_view text, const std::string& name, FaultList& faults);

/// Applies `KEY.PATH=VALUE` of the command line to a document. VALUE is TOML, or else plain text, so that
/// both `rock.poissons_ratio=0.25` and `mesh.fracture_size=0.5 m` are understood. Adds to `faults` if it
/// cannot be.
void apply_override(SourceValue& document, const std::string& assignment, FaultList& faults);

}  // namespace fissura::input
