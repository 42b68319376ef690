// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/byte_archive.hpp"

/// What stands around the state that a participant saves: whose it is before, a checksum of everything
/// behind.
namespace fissura {

/// Whose state it is. All of it must be the same for a state to be restored.
struct StateOwner {
  std::string solver;        ///< "structure" or "network"
  std::string program;       ///< name and version
  std::uint64_t format = 0;  ///< of the state itself
  std::string case_hash;     ///< see case_hash()
};

/// Begins a blob: the state follows.
void begin_state(const StateOwner& owner, ByteWriter& bytes);
/// Ends it.
std::vector<std::byte> end_state(ByteWriter& bytes);

/// The state inside a blob. Throws Error(checkpoint_unusable) with a sentence that names what does not fit:
/// damaged bytes, another solver, program, format or case.
std::span<const std::byte> state_inside(std::span<const std::byte> blob, const StateOwner& owner);

}  // namespace fissura
