// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupler/launch/status_page.hpp"

namespace fissura::coupler {

/// When the supervisor lets the run go on after a death.
struct Healing {
  bool wanted = false;
  int deaths_at_one_place = 3;  ///< so many without a checkpoint between them, and it gives up
};

/// One life of the run that ended before its time, and from where the next went on.
struct Death {
  std::uint32_t epoch = 0;
  RunFailure failure;
  std::optional<std::uint64_t> checkpoint;  ///< interval the run could go on from; the beginning without
};

/// Whether another life may end otherwise after this exit code: something died, hung, broke the protocol or
/// ran out of memory. Not after what would happen again (the case, the numbers, the disk).
bool is_healed(int exit_code);

/// Counts deaths and says when the run goes on.
class Healer {
 public:
  explicit Healer(const Healing& healing) : healing_(healing) {}

  /// Notes a death. @returns whether the run goes on. @throws nothing; if it gives up, the sentence of
  /// `death.failure` says so
  bool goes_on_after(Death& death);
  [[nodiscard]] const std::vector<Death>& deaths() const { return deaths_; }

 private:
  Healing healing_;
  std::vector<Death> deaths_;
  int deaths_here_ = 0;
};

/// The line that says so, without the newline.
std::string healing_line(const Death& death);

}  // namespace fissura::coupler
