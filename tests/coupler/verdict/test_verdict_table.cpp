// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <sstream>

#include "coupler/verdict/verdict_table.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("the table shows each quantity in its unit, what could not be judged, and the verdict",
          "[coupler][verdict]") {
  Verdict verdict;
  verdict.judgement = Judgement::fail;
  verdict.quantities = {
      {"half_length", Measure::mean_relative_error, "m", 12.5, 12.625, 0.01, 0.02, true, ""},
      {"relative_residual", Measure::maximum, "1", 1e-10, 3e-16, {}, {}, true, ""},
      {"efficiency", Measure::value_at, "1", 0.5, {}, {}, 0.02, false, "the run ended at 1 s, before 2 s"},
  };
  std::istringstream stream(verdict_table(verdict));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  REQUIRE(lines.size() == 5);
  CHECK(lines[0] ==
        "quantity           measure              expected  obtained  unit    error  tolerance  result");
  CHECK(lines[1] ==
        "half_length        mean_relative_error      12.5    12.625  m     +1.00 %        2 %  pass");
  CHECK(lines[2] ==
        "relative_residual  maximum              <= 1e-10     3e-16  -           -          -  pass");
  CHECK(lines[3] ==
        "efficiency         value_at                  0.5         -  -           -        2 %  "
        "FAIL: the run ended at 1 s, before 2 s");
  CHECK(lines[4] == "verdict: fail (2 of 3 quantities)");
}

TEST_CASE("a case without expectations says so", "[coupler][verdict]") {
  CHECK(verdict_table({}) == "verdict: none (nothing was expected)\n");
}
