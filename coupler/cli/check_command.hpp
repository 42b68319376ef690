// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "common/case/read_case.hpp"

namespace fissura::coupler {

/// `coupler check`: every fault of case and expectations (thrown as CaseFaults), or the warnings, how natural
/// fractures came about and the derived numbers on standard output; and a picture of the case in the file
/// `picture`, if one is named. @returns the exit code
int check_command(const CaseSource& source, const std::optional<std::filesystem::path>& picture);

}  // namespace fissura::coupler
