// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace fissura::coupler {

/// Tells in which order processes ended, also of those that ended while nobody looked: the kernel queues
/// their pidfds as they become readable.
class DeathWatch {
 public:
  /// Throws Error(precondition) if the system has no descriptor left.
  DeathWatch();
  ~DeathWatch();
  DeathWatch(const DeathWatch&) = delete;
  DeathWatch& operator=(const DeathWatch&) = delete;

  /// Watches the process behind `pidfd`, to be told of as `number`.
  void add(int pidfd, std::size_t number);
  void remove(int pidfd);

  /// Readable as soon as one of them has ended.
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Numbers of those that have ended, the first first. Does not wait.
  [[nodiscard]] std::vector<std::size_t> ended() const;

 private:
  int descriptor_ = -1;
};

}  // namespace fissura::coupler
