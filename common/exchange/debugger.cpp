// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/debugger.hpp"

#include <cstdlib>

namespace fissura {

namespace {
constexpr const char* variable = "FISSURA_DEBUG_ATTACH";
}

void announce_debugger() {
  ::setenv(variable, "1", 1);
}

bool may_be_held() {
  return std::getenv(variable) != nullptr;
}

}  // namespace fissura
