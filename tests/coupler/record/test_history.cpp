// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "coupler/record/history.hpp"
#include "coupler/record/recorded_scalars.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura::coupler;

namespace {

std::vector<std::string> cells(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> result;
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

}  // namespace

TEST_CASE("history.csv gives back every scalar of the record to the last bit", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  History history;
  history.write_to(folder.path());
  history.add(sample::interval(1, 0.1));
  history.add(sample::interval(2, 0.1 + 0.2));
  history.flush();

  const auto lines = sample::lines(folder.path() / "history.csv");
  REQUIRE(lines.size() == 3);
  const auto header = cells(lines[0]);
  REQUIRE(header.size() == recorded_scalars().size());
  for (std::size_t column = 0; column < header.size(); ++column) {
    INFO(header[column]);
    CHECK(header[column] == recorded_scalars()[column].name);
    const double printed = std::stod(cells(lines[2])[column]);
    CHECK(printed == recorded_scalars()[column].value(sample::interval(2, 0.1 + 0.2)));
    CHECK(printed == history.series(header[column])->back());
  }
}

TEST_CASE("a new member of IntervalRecord is not forgotten in the tables", "[coupler][record]") {
  // Two 4-byte members share 8 bytes and `explicit_steps` is padded: three ints take the room of two doubles.
  CHECK(sizeof(IntervalRecord) == (recorded_scalars().size() - 1) * sizeof(double));
}

TEST_CASE("two columns do not read the same member", "[coupler][record]") {
  const IntervalRecord record = sample::interval(2, 0.3);
  for (const RecordedScalar& first : recorded_scalars())
    for (const RecordedScalar& second : recorded_scalars()) {
      INFO(first.name << " and " << second.name);
      CHECK((first.name == second.name) == (first.value(record) == second.value(record)));
    }
}

TEST_CASE("ledger.csv holds the fluid volumes and what is missing between them", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  History history;
  history.write_to(folder.path());
  history.add(sample::interval(4, 0.5));
  history.flush();
  const auto lines = sample::lines(folder.path() / "ledger.csv");
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] ==
        "interval,time,injected,in_place,found,in_fractures,leaked,reset,residual,relative_residual");
  CHECK(lines[1] == "4,0.5,0.001,2e-06,5e-06,0.0009,0.0001,3e-09,1e-19,1e-16");
}

TEST_CASE("columns.json tells the unit of every column of history.csv", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  History history;
  history.write_to(folder.path());
  const auto columns = nlohmann::json::parse(sample::content(folder.path() / "columns.json"));
  REQUIRE(columns.size() == recorded_scalars().size());
  for (const auto& column : columns) CHECK_FALSE(column["unit"].get<std::string>().empty());
}

TEST_CASE("a column that does not exist has no series", "[coupler][record]") {
  History history;
  history.add(sample::interval(1, 0.1));
  CHECK_FALSE(history.series("half_lenght").has_value());
  CHECK(history.series("half_length")->size() == 1);
}
