// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "common/case/expected.hpp"
#include "tests/common/case_fixture.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

const std::array columns{HistoryColumn{"time", "s"}, HistoryColumn{"half_length", "m"},
                             HistoryColumn{"inlet_aperture", "m"}, HistoryColumn{"relative_residual", "1"}};

Expectations read(const Folder& folder, const std::string& text) {
  folder.write("expected.toml", text);
  return read_expectations(folder.path() / "expected.toml", 20, columns);
}

}  // namespace

TEST_CASE("expected.toml: every measure is read in SI", "[common][case][expected]") {
  const Folder folder;
  folder.write("reference.csv", "time,half_length\n0,0\n");
  const std::vector<ExpectedQuantity> quantities = read(folder, R"(
[[quantity]]
name = "half_length"
unit = "m"
measure = "mean_relative_error"
reference = "reference.csv"
from = "5 s"
to = "10 s"
tolerance = 0.02
reason = "h = L/20"
[[quantity]]
name = "inlet_aperture"
unit = "mm"
measure = "value_at"
at = "10 s"
value = "0.711 mm"
tolerance = 0.025
reason = "the semi-analytical solution"
[[quantity]]
name = "relative_residual"
unit = "1"
measure = "maximum"
at_most = 1e-10
reason = "rounding of the ledger"
[[quantity]]
name = "inlet_aperture"
unit = "mm"
measure = "minimum"
at_least = "10 um"
reason = "never closed"
[[quantity]]
name = "inlet_aperture"
unit = "um"
measure = "time_when_below"
value = "1 um"
expected = "14.1 s"
tolerance = 0.05
reason = "closure"
)")
                                                       .quantities;
  REQUIRE(quantities.size() == 5);
  CHECK(quantities[0].measure == Measure::mean_relative_error);
  CHECK(quantities[0].reference.filename() == "reference.csv");
  CHECK(quantities[0].from == 5);
  CHECK(quantities[0].to == 10);
  CHECK(quantities[0].tolerance == 0.02);
  CHECK(quantities[1].value == Approx(0.711e-3).epsilon(1e-15));
  CHECK(quantities[1].unit_in_si == 1e-3);
  CHECK(quantities[1].at == 10);
  CHECK(quantities[2].bound == 1e-10);
  CHECK(quantities[2].from == 0);
  CHECK(quantities[2].to == 20);
  CHECK(quantities[3].bound == 10e-6);
  CHECK(quantities[4].expected_time == 14.1);
  CHECK(quantities[4].value == 1e-6);
}

TEST_CASE("expected.toml: every fault is told at once", "[common][case][expected]") {
  const Folder folder;
  try {
    read(folder, R"([[quantity]]
name = "half_lenght"
unit = "m"
measure = "maximum"
at_most = "10 m"
reason = "r"
[[quantity]]
name = "inlet_aperture"
unit = "Pa"
measure = "value_at"
at = "30 s"
value = 0.711
tolerance = 0.02
[[quantity]]
name = "half_length"
unit = "m"
measure = "mean_relative_error"
reference = "none.csv"
tolerance = 0
reason = "r"
)");
    FAIL("accepted");
  } catch (const CaseFaults& refusal) {
    std::vector<std::string> keys;
    for (const Fault& fault : refusal.faults()) keys.push_back(fault.key);
    CHECK(keys == std::vector<std::string>{"quantity[0].name", "quantity[1].reason", "quantity[1].unit",
                                           "quantity[1].at", "quantity[1].value", "quantity[2].reference",
                                           "quantity[2].tolerance"});
    CHECK(refusal.faults()[0].suggestion == "half_length");
  }
}
