// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/errors.hpp"
#include "coupler/verdict/reference_table.hpp"
#include "tests/coupler/verdict/reference_file.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("a reference is read with its comments skipped", "[coupler][verdict]") {
  const ReferenceFile file("# Dontsov (2017)\ntime, half_length\n\n1, 5.5e0\r\n2,7\n");
  const ReferenceTable table(file.path());
  CHECK(value_at(table.series("half_length"), 1.5).value() == Approx(6.25).epsilon(1e-15));
  CHECK_THROWS_WITH(table.series("efficiency"), Catch::Contains("no column \"efficiency\""));
}

TEST_CASE("a fault in a reference is told with its line", "[coupler][verdict]") {
  const auto fault = [](const char* text, const char* sentence) {
    const ReferenceFile file(text);
    CHECK_THROWS_AS(ReferenceTable(file.path()), InputError);
    CHECK_THROWS_WITH(ReferenceTable(file.path()), Catch::Contains(sentence));
  };
  fault("time,a\n1,2\n2\n", ":3: 2 columns were expected, found 1");
  fault("time,a\n1,two\n", ":2: a number was expected for a, found \"two\"");
  fault("time,a\n1,nan\n", ":2: a number was expected");
  fault("time,a\n2,1\n2,1\n", ":3: the time must rise");
  fault("t,a\n1,2\n", "a column \"time\"");
  fault("", "a column \"time\"");
  CHECK_THROWS_AS(ReferenceTable("/nonexistent.csv"), InputError);
}
