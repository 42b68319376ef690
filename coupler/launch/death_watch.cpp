// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/death_watch.hpp"

#include <sys/epoll.h>
#include <unistd.h>

#include <array>

#include "common/errors.hpp"

namespace fissura::coupler {

DeathWatch::DeathWatch() : descriptor_(::epoll_create1(EPOLL_CLOEXEC)) {
  if (descriptor_ < 0)
    throw Error(ExitCode::precondition, "no file descriptor is left to watch processes with");
}

DeathWatch::~DeathWatch() {
  ::close(descriptor_);
}

void DeathWatch::add(int pidfd, std::size_t number) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.u64 = number;
  if (::epoll_ctl(descriptor_, EPOLL_CTL_ADD, pidfd, &event) != 0)
    throw Error(ExitCode::precondition, "cannot watch a process");
}

void DeathWatch::remove(int pidfd) {
  ::epoll_ctl(descriptor_, EPOLL_CTL_DEL, pidfd, nullptr);
}

std::vector<std::size_t> DeathWatch::ended() const {
  std::array<epoll_event, 8> events{};
  const int count = ::epoll_wait(descriptor_, events.data(), static_cast<int>(events.size()), 0);
  std::vector<std::size_t> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(events[static_cast<std::size_t>(i)].data.u64);
  return numbers;
}

}  // namespace fissura::coupler
