// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include "coupler/launch/trio.hpp"

namespace fissura::coupler {

/// What `read` makes of a message of `role`. Throws ParticipantFailure: what is wrong with it is the fault of
/// that participant.
template <typename Read>
auto told_by(Role role, const Read& read) {
  try {
    return read();
  } catch (const Error& fault) {
    throw ParticipantFailure(fault.code(), role,
                             fmt::format("{} sent what cannot be: {}", name(role), fault.what()));
  }
}

}  // namespace fissura::coupler
