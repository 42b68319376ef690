// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "coupler/verdict/series.hpp"

using namespace fissura::coupler;

TEST_CASE("a mean over unequal coupling intervals is weighted with their length", "[coupler][verdict]") {
  const std::vector<double> time{1, 2, 6}, value{10, 20, 30};
  // One second of 10, one of 20, four of 30.
  CHECK(time_mean(cut({time, value}, {0, 6})) == Approx(25.0).epsilon(1e-15));
  CHECK(time_mean(cut({time, value}, {2, 6})) == Approx(28.0).epsilon(1e-15));
}

TEST_CASE("the ends of a window belong to it, also when they are off by a rounding error",
          "[coupler][verdict]") {
  const std::vector<double> time{0.1, 0.1 + 0.2, 10.000000000000002}, value{1, 2, 3};
  CHECK(cut({time, value}, {0.3, 10}).value == std::vector<double>{2, 3});
  CHECK(TimeWindow{0, 10}.is_over_at(9.999999999999998));
  CHECK_FALSE(TimeWindow{0, 10}.is_over_at(9.999));
}

TEST_CASE("a value between two coupling times is interpolated, and none is made up outside",
          "[coupler][verdict]") {
  const std::vector<double> time{1, 3}, value{10, 30};
  CHECK(value_at({time, value}, 2).value() == Approx(20.0).epsilon(1e-15));
  CHECK(value_at({time, value}, 1).value() == 10);
  CHECK(value_at({time, value}, 3.0000000000000004).value() == 30);
  CHECK_FALSE(value_at({time, value}, 0.5).has_value());
  CHECK_FALSE(value_at({time, value}, 3.5).has_value());
  CHECK_FALSE(value_at({}, 1).has_value());
}

TEST_CASE("the time of closing is where the line between two coupling times crosses the threshold",
          "[coupler][verdict]") {
  const std::vector<double> time{1, 2, 3, 4}, value{0.5, 8, 4, 0};
  // From 4 at 3 s to 0 at 4 s: 1 is crossed at 3.75 s. The low value at 1 s lies before the window.
  CHECK(first_time_below({time, value}, {2, 4}, 1).value() == Approx(3.75).epsilon(1e-15));
  CHECK(first_time_below({time, value}, {1, 4}, 1).value() == 1);
  CHECK_FALSE(first_time_below({time, value}, {2, 3}, 1).has_value());
}
