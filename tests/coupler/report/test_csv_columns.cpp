// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "common/errors.hpp"
#include "coupler/report/csv_columns.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

CsvColumns table(const std::string& text) {
  const sample::TemporaryDirectory folder;
  std::ofstream(folder.path() / "table.csv") << text;
  return CsvColumns(folder.path() / "table.csv");
}

}  // namespace

TEST_CASE("a line that is still being written is not read", "[coupler][report]") {
  const CsvColumns cut = table("time,value\n0.1,3\n0.2,1.2");
  CHECK(cut.rows() == 1);
  CHECK(cut.numbers("value") == std::vector<double>{3});
  CHECK(table("time,val").rows() == 0);
  CHECK(table("").rows() == 0);
}

TEST_CASE("cells in quotes may hold commas and quotes", "[coupler][report]") {
  CHECK(table("name,x\n\"a, \"\"b\"\"\",2\n").texts("name") == std::vector<std::string>{"a, \"b\""});
}

TEST_CASE("numbers that are not finite are numbers, words are not", "[coupler][report]") {
  CHECK(std::isnan(table("x\nnan\n").numbers("x")[0]));
  CHECK(std::isinf(table("x\ninf\n").numbers("x")[0]));
  CHECK_THROWS_AS(table("x\nmany\n").numbers("x"), InputError);
  CHECK_THROWS_AS(table("x\n1\n").numbers("y"), InputError);
  CHECK_THROWS_WITH(table("x,y\n1,2\n1\n"), Catch::Contains("table.csv:3") && Catch::Contains("2 cells"));
}

TEST_CASE("a table with a column that is there twice is refused", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  std::ofstream(folder.path() / "t.csv") << "time,a,a\n1,2,3\n";
  CHECK_THROWS_AS(CsvColumns(folder.path() / "t.csv"), InputError);
}
