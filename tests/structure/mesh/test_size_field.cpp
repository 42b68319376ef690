// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "structure/mesh/size_field.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

const MeshControls controls{0.5, 8, 2, 0.25, 1, 0.5, 2, 0.4, {}, {}};

std::vector<SizedSegment> random_segments(std::size_t count) {
  std::mt19937_64 random(3);
  const auto uniform = [&] { return 100 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5); };
  std::vector<SizedSegment> segments;
  for (std::size_t i = 0; i < count; ++i) {
    const Point begin{uniform(), uniform()};
    segments.push_back({begin, {begin[0] + uniform() / 10, begin[1] + uniform() / 10}, 0.5, 0.5});
  }
  return segments;
}

}  // namespace

TEST_CASE("the target size is uniform in the corridor, then grows linearly up to the far size",
          "[structure][mesh]") {
  const std::vector<SizedSegment> line{{{-1, 0}, {1, 0}, 0.5, 0.5}};
  const SizeField field(controls, line, {});
  CHECK(field.size({0, 0}) == 0.5);
  CHECK(field.size({0, 2}) == 0.5);
  CHECK(field.size({0, -4}) == Approx(0.5 + 0.25 * 2).epsilon(1e-14));
  CHECK(field.size({9, 0}) == Approx(0.5 + 0.25 * 6).epsilon(1e-14));
  CHECK(field.size({0, 1000}) == 8);
  CHECK(field.distance({4, 4}) == Approx(5).epsilon(1e-14));
}

TEST_CASE("without lines the target size is the far size", "[structure][mesh]") {
  const SizeField field(controls, {}, {});
  CHECK(field.size({3, 4}) == 8);
  CHECK(std::isinf(field.distance({3, 4})));
}

TEST_CASE("the target size starts at the edge length of a short stretch of line", "[structure][mesh]") {
  const std::vector<SizedSegment> lines{{{-10, 0}, {0, 0}, 0.5, 0.5}, {{0, 0}, {0.1, 0}, 0.1, 0.5}};
  const SizeField field(controls, lines, {});
  CHECK(field.size({0.05, 0}) == Approx(0.1).epsilon(1e-14));
  CHECK(field.size({0.05, 1}) > 0.1);
  CHECK(field.size({-5, 0}) == 0.5);
}

TEST_CASE("the nearest of a thousand segments is that of a search through all", "[structure][mesh]") {
  const std::vector<SizedSegment> segments = random_segments(1000);
  const SizeField field(controls, segments, {});
  for (int i = 0; i < 500; ++i) {
    const Point point{60 * std::sin(1.0 * i), 60 * std::cos(2.3 * i)};
    double nearest = std::numeric_limits<double>::infinity();
    for (const SizedSegment& s : segments)
      nearest = std::min(nearest, distance_to_segment(point, s.begin, s.end));
    REQUIRE(field.distance(point) == nearest);
  }
}
