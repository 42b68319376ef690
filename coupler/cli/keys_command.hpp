// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace fissura::coupler {

/// `coupler keys new DIR`: makes the keys of one trio and prints which of the files goes to which host.
/// Throws Error.
int new_keys_command(const std::filesystem::path& directory);

}  // namespace fissura::coupler
