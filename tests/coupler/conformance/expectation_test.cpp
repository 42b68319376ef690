// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/expectation.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "coupler/conformance/check.hpp"

using namespace fissura::coupler::conformance;

TEST_CASE("expectation: what is not a number is close to nothing and within nothing",
          "[coupler][conformance]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(require_close("p", nan, 1, 1e300), Deviation);
  CHECK_THROWS_AS(require_ratio("p", nan, 1, 1e300), Deviation);
  CHECK_THROWS_AS(require_within("p", nan, -1, 1), Deviation);
  CHECK_THROWS_AS(require_within("p", std::numeric_limits<double>::infinity(), 0,
                                 std::numeric_limits<double>::infinity()),
                  Deviation);
}

TEST_CASE("expectation: a tolerance holds up to its edge and no further", "[coupler][conformance]") {
  CHECK_NOTHROW(require_close("p", 1.5, 1, 0.5));
  CHECK_THROWS_AS(require_close("p", 1.5000001, 1, 0.5), Deviation);
  CHECK_NOTHROW(require_ratio("p", -3, -2, 0.5));
  CHECK_THROWS_AS(require_ratio("p", -3.000001, -2, 0.5), Deviation);
  CHECK_NOTHROW(require_within("p", 2, 2, 3));
  CHECK_THROWS_AS(require_within("p", 3.0000001, 2, 3), Deviation);
}

TEST_CASE("expectation: bits tell zero from minus zero, and name the first place", "[coupler][conformance]") {
  CHECK_NOTHROW(require_same_bits("pressure of node", {0.0, 1.0}, {0.0, 1.0}));
  try {
    require_same_bits("pressure of node", {1.0, -0.0}, {1.0, 0.0});
    FAIL("nothing was thrown");
  } catch (const Deviation& deviation) {
    CHECK(deviation.expected() == "pressure of node 1 0, bit for bit");
    CHECK(deviation.obtained() == "-0");
  }
  CHECK_THROWS_AS(require_same_bits("pressure of node", {1.0}, {1.0, 2.0}), Deviation);
}
