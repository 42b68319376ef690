// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/machine_check.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "common/errors.hpp"

namespace fissura::coupler {

void require_descriptors() {
  constexpr rlim_t needed = 64;  // sockets and their threads take some thirty, open results the rest
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= needed) return;
  throw Error(ExitCode::precondition,
              fmt::format("a run needs {} file descriptors, this process may open {}: raise it with ulimit -n",
                          needed, limit.rlim_cur));
}

}  // namespace fissura::coupler
