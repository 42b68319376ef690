// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/forked_peer.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>

#include "common/errors.hpp"

namespace fissura::bench {

coupler::ChildProcess forked_peer(const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child < 0) throw Error(ExitCode::precondition, "cannot fork");
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    work();
    ::_exit(0);
  }
  return coupler::ChildProcess(child);
}

}  // namespace fissura::bench
