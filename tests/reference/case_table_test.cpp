// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/case_table.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

using namespace fissura::reference;

namespace {

std::vector<std::vector<double>> numbers_of(std::istream& csv) {
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(csv, line);
  while (std::getline(csv, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

}  // namespace

TEST_CASE("reference.csv of every case is what reference_table prints", "[reference][cases]") {
  const std::string name = GENERATE(from_range(cases_with_reference()));
  INFO(name);
  std::ifstream file(std::string(CASES_DIRECTORY) + "/" + name + "/reference.csv");
  REQUIRE(file);
  std::istringstream fresh(as_csv(case_table(name)));
  const auto committed = numbers_of(file), computed = numbers_of(fresh);
  REQUIRE(committed.size() == computed.size());
  for (std::size_t i = 0; i < computed.size(); ++i) {
    REQUIRE(committed[i].size() == computed[i].size());
    // The last printed digit may differ between machines.
    for (std::size_t j = 0; j < computed[i].size(); ++j)
      CHECK(committed[i][j] == Approx(computed[i][j]).epsilon(2e-5));
  }
}
