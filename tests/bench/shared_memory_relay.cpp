// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/shared_memory_relay.hpp"

#include <linux/futex.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <new>

#include "common/errors.hpp"
#include "tests/bench/forked_peer.hpp"

namespace fissura::bench {

namespace {

/// A counter that a process of another address space can wait for.
class Bell {
 public:
  void ring() {
    rung_.fetch_add(1, std::memory_order_release);
    ::syscall(SYS_futex, &rung_, FUTEX_WAKE, 1, nullptr, nullptr, 0);
  }
  /// Returns when it has been rung more often than `heard`, and counts one more as heard.
  void wait(std::uint32_t& heard) {
    while (rung_.load(std::memory_order_acquire) == heard)
      ::syscall(SYS_futex, &rung_, FUTEX_WAIT, heard, nullptr, nullptr, 0);
    ++heard;
  }

 private:
  std::atomic<std::uint32_t> rung_{0};
};

void copy_in(const std::vector<double>& values, double* to) {
  std::memcpy(to, values.data(), values.size() * sizeof(double));
}

}  // namespace

/// Between the coupler and one participant; the arrays follow it in memory.
struct SharedMemoryRelay::Lane {
  Bell command, answer;
  std::size_t count = 0;  ///< values per array; 0 ends the participant
  std::uint32_t answers_heard = 0;

  double* arrays() { return reinterpret_cast<double*>(this + 1); }

  void serve(std::size_t answer_arrays) {
    std::uint32_t heard = 0;
    std::vector<double> values;
    for (command.wait(heard); count > 0; command.wait(heard)) {
      values.resize(answer_arrays * count, 1.0);
      copy_in(values, arrays() + advance_arrays * count);
      answer.ring();
    }
  }
};

SharedMemoryRelay::SharedMemoryRelay(std::size_t largest)
    : lane_size_(sizeof(Lane) + (advance_arrays + response_arrays) * largest * sizeof(double)) {
  memory_ = ::mmap(nullptr, 2 * lane_size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory_ == MAP_FAILED) throw Error(ExitCode::out_of_memory, "no shared memory");
  for (const std::size_t peer : {0u, 1u}) {
    Lane* lane = new (lane_of(peer)) Lane;
    peers_.push_back(forked_peer([=] { lane->serve(peer == 0 ? pressure_arrays : response_arrays); }));
  }
}

SharedMemoryRelay::~SharedMemoryRelay() {
  for (const std::size_t peer : {0u, 1u}) {
    lane_of(peer)->count = 0;
    lane_of(peer)->command.ring();
    peers_[peer].wait_or_kill(1);
  }
  ::munmap(memory_, 2 * lane_size_);
}

SharedMemoryRelay::Lane* SharedMemoryRelay::lane_of(std::size_t peer) const {
  return reinterpret_cast<Lane*>(static_cast<std::byte*>(memory_) + peer * lane_size_);
}

void SharedMemoryRelay::set_values(std::size_t count) {
  count_ = count;
  values_.assign(advance_arrays * count, 1.0);
}

void SharedMemoryRelay::step() {
  for (const std::size_t peer : {0u, 1u}) {
    Lane& lane = *lane_of(peer);
    lane.count = count_;
    copy_in(values_, lane.arrays());
    lane.command.ring();
    lane.answer.wait(lane.answers_heard);
  }
}

}  // namespace fissura::bench
