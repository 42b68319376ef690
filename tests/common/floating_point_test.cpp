// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/floating_point.hpp"

#include <catch2/catch.hpp>
#include <cfenv>

#include "common/faults/fault_point.hpp"

using namespace fissura;

namespace {

/// What is found after a solver left arithmetic so; everything is as before afterwards.
std::string found_after(FaultAction change) {
  std::fenv_t before;
  std::fegetenv(&before);
  ProcessFault fault;
  fault.phase = FaultPhase::advance;
  fault.action = change;
  arm_faults({fault});
  fault_point(FaultPhase::advance, 1);
  const std::optional<std::string> found = changed_floating_point();
  std::fesetenv(&before);
  arm_faults({});
  return found.value_or("");
}

}  // namespace

TEST_CASE("rounding and denormal numbers that a solver left changed are found", "[common][exchange]") {
  CHECK_FALSE(changed_floating_point());
  CHECK(found_after(FaultAction::round_up) == "numbers are rounded upward instead of to nearest");
  CHECK(found_after(FaultAction::flush_denormals) ==
        "numbers below the smallest normal one are replaced by zero");
  CHECK_FALSE(changed_floating_point());
}
