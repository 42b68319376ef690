// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "coupler/launch/child_process.hpp"
#include "tests/bench/relay.hpp"

namespace fissura::bench {

/// The limit of what processes can do: arrays in memory that all three share, copied in by the sender and
/// read in place by the receiver, who sleeps on a futex until they are there.
class SharedMemoryRelay : public Relay {
 public:
  /// @param largest  values per array at most
  explicit SharedMemoryRelay(std::size_t largest);
  ~SharedMemoryRelay() override;
  SharedMemoryRelay(const SharedMemoryRelay&) = delete;
  SharedMemoryRelay& operator=(const SharedMemoryRelay&) = delete;

  void set_values(std::size_t count) override;
  void step() override;

 private:
  struct Lane;

  Lane* lane_of(std::size_t peer) const;

  std::size_t lane_size_;
  void* memory_;
  std::vector<coupler::ChildProcess> peers_;
  std::size_t count_ = 0;
  std::vector<double> values_;  ///< of all arrays to a participant
};

}  // namespace fissura::bench
