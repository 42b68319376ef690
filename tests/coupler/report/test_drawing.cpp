// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "coupler/report/drawn_numbers.hpp"
#include "coupler/report/thinning.hpp"

using namespace fissura::coupler;

TEST_CASE("numbers for a picture have five digits", "[coupler][report]") {
  CHECK(for_drawing(1234567.0) == 1234600.0);
  CHECK(for_drawing(-0.00071415123) == -0.00071415);
  CHECK(for_drawing(0.0) == 0.0);
  CHECK(for_drawing(1e-300) == 1e-300);
  CHECK(for_drawing(std::vector<double>{std::numeric_limits<double>::quiet_NaN()}).dump() == "[null]");
}

TEST_CASE("a short table is drawn whole, and of a long one the peaks stay", "[coupler][report]") {
  std::vector<double> residual(100'000, 1.0);
  residual[77'777] = 5;
  const std::vector<std::vector<double>> peaks{residual};
  CHECK(rows_to_draw(3, {}, 1000) == std::vector<std::size_t>{0, 1, 2});
  const std::vector<std::size_t> rows = rows_to_draw(residual.size(), peaks, 1000);
  CHECK(rows.size() <= 2001);
  CHECK(rows.front() == 0);
  CHECK(rows.back() == residual.size() - 1);
  CHECK(std::count(rows.begin(), rows.end(), std::size_t{77'777}) == 1);
  CHECK(std::is_sorted(rows.begin(), rows.end()));
}

TEST_CASE("reports are chosen evenly and with the last", "[coupler][report]") {
  CHECK(evenly_spread(2, 60) == std::vector<std::size_t>{0, 1});
  CHECK(evenly_spread(9, 3) == std::vector<std::size_t>{2, 5, 8});
  CHECK(evenly_spread(0, 3).empty());
}
