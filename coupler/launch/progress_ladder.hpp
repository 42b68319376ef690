// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

namespace fissura::coupler {

/// What comes of a participant that is at work and says nothing: a warning after a tenth of its deadline, a
/// diagnosis after three tenths, the end of the run after all of it.
enum class Rung { warning, diagnosis, end };

class ProgressLadder {
 public:
  /// @param deadline  wall time without any word [s]
  explicit ProgressLadder(double deadline) : deadline_(deadline) {}

  /// The next rung that so many seconds of silence have reached, each once; a shorter silence than at the
  /// last call begins anew.
  std::optional<Rung> climb(double silent_seconds);

 private:
  double deadline_;
  double silence_ = 0;
  std::size_t climbed_ = 0;
};

}  // namespace fissura::coupler
