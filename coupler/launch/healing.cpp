// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/healing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "common/errors.hpp"
#include "coupler/launch/last_line.hpp"

namespace fissura::coupler {

bool is_healed(int exit_code) {
  constexpr std::array healed{ExitCode::participant_died,   ExitCode::participant_unresponsive,
                              ExitCode::protocol_violation, ExitCode::invalid_values,
                              ExitCode::out_of_memory,      ExitCode::internal};
  return std::find(healed.begin(), healed.end(), static_cast<ExitCode>(exit_code)) != healed.end();
}

bool Healer::goes_on_after(Death& death) {
  const bool new_checkpoint = !deaths_.empty() && deaths_.back().checkpoint != death.checkpoint;
  deaths_here_ = new_checkpoint ? 1 : deaths_here_ + 1;
  bool goes_on = healing_.wanted && is_healed(death.failure.exit_code);
  if (goes_on && deaths_here_ >= healing_.deaths_at_one_place) {
    goes_on = false;
    death.failure.sentence = fmt::format("{}; healing ends after {} deaths without a checkpoint between them",
                                         death.failure.sentence.text(), deaths_here_);
  }
  deaths_.push_back(death);
  return goes_on;
}

std::string healing_line(const Death& death) {
  return fmt::format("coupler: healing: {} {} interval={} phase={}: {}. The run goes on from {} (epoch {})",
                     name_of_code(death.failure.exit_code), death.failure.who.text(), death.failure.interval,
                     death.failure.phase.text(), death.failure.sentence.text(), place(death.checkpoint),
                     death.epoch + 1);
}

}  // namespace fissura::coupler
