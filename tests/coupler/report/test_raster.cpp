// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "coupler/report/raster.hpp"

using namespace fissura::coupler;

namespace {

/// The square from (0, 0) to (1, 1), of two triangles.
const std::vector<double> position{0, 0, 1, 0, 1, 1, 0, 1};
const std::vector<double> elements{0, 1, 2, 0, 2, 3};

}  // namespace

TEST_CASE("a linear field is drawn exactly at the middles of the cells, and nothing beside the mesh",
          "[coupler][report]") {
  const View view{"", -0.5, 1.5, 0, 1};
  std::vector<double> values;
  for (std::size_t node = 0; node < 4; ++node)
    values.push_back(3 + 2 * position[2 * node] - 5 * position[2 * node + 1]);
  const Raster raster = rasterised(position, elements, values, view, empty_raster(view, 800));
  REQUIRE(raster.columns == 40);
  REQUIRE(raster.rows == 20);
  for (std::size_t row = 0; row < raster.rows; ++row)
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const double x = -0.5 + (double(column) + 0.5) * 0.05, y = (double(row) + 0.5) * 0.05;
      const double drawn = raster.values[row * raster.columns + column];
      if (x < 0 || x > 1)
        CHECK(std::isnan(drawn));
      else
        CHECK(drawn == Approx(3 + 2 * x - 5 * y).epsilon(1e-12));
    }
}

TEST_CASE("a node has the mean of its elements, weighted with their areas", "[coupler][report]") {
  const std::vector<double> stretched{0, 0, 1, 0, 1, 3, 0, 1};
  // Areas 1.5 and 0.5.
  const std::vector<double> found = at_nodes(stretched, elements, {4, 8});
  CHECK(found[1] == 4);
  CHECK(found[3] == 8);
  CHECK(found[0] == Approx((1.5 * 4 + 0.5 * 8) / 2));
  CHECK(found[2] == found[0]);
}

TEST_CASE("faces of a fracture that touch keep their own values", "[coupler][report]") {
  const std::vector<double> split{0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 1};
  const std::vector<double> found = at_nodes(split, {0, 1, 2, 4, 5, 3}, {4, 8});
  CHECK(found[0] == 4);
  CHECK(found[4] == 8);
}

TEST_CASE("values become bytes between the limits, cut off beyond them", "[coupler][report]") {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  // 0, 127, 254, 0, 254, 255.
  CHECK(as_bytes({-1, 0, 1, -7, 9, nothing}, -1, 1) == "AH/+AP7/");
  CHECK(as_bytes({-1}, -1, 1) == "AA==");
  CHECK(as_bytes({-1, 1}, -1, 1) == "AP4=");
}
