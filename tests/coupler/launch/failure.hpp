// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/errors.hpp"
#include "coupler/launch/status_page.hpp"

namespace fissura::coupler::sample {

inline RunFailure failure(ExitCode code, const char* who, std::uint64_t interval, const char* sentence) {
  RunFailure failure;
  failure.exit_code = static_cast<int>(code);
  failure.who = who;
  failure.interval = interval;
  failure.phase = "network";
  failure.sentence = sentence;
  return failure;
}

}  // namespace fissura::coupler::sample
