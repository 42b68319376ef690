// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace fissura::coupler {

/// How many processes the kernel has killed for want of memory in the control group (version 2) of this
/// process; nothing where the kernel does not tell.
std::optional<std::uint64_t> memory_kills();

}  // namespace fissura::coupler
