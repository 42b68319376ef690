// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/tell.hpp"

#include <unistd.h>

#include <cstdio>

namespace fissura::coupler {

void tell(const std::string& line) {
  std::fprintf(stderr, "%s%s\n", ::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "", line.c_str());
}

}  // namespace fissura::coupler
