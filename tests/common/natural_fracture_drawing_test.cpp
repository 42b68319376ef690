// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "common/natural_fractures/draw_traces.hpp"
#include "common/natural_fractures/planar_segment.hpp"
#include "common/natural_fractures/scatter.hpp"
#include "common/natural_fractures/set_statistics.hpp"

using namespace fissura;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Two sets in a square of 1000 m: strike 90 and 330 degrees, deviations 5 degrees and a tenth.
NaturalFractureSet set_of(double azimuth, double spacing, double length, double persistence,
                          PersistenceReading reading, std::uint64_t seed) {
  NaturalFractureSet set;
  set.name = "joints";
  set.orientation = {azimuth * degree, 5 * degree};
  set.spacing = {spacing, spacing / 10};
  set.length = {length, length / 10};
  set.persistence = {persistence, persistence / 10};
  set.reading = reading;
  set.seed = seed;
  set.west = set.south = -500;
  set.east = set.north = 500;
  return set;
}

// Of a thousand honest means, fewer than one lies farther off than four standard errors.
constexpr double standard_errors = 4;

void check_mean(const QuantityStatistics& quantity) {
  INFO(quantity.obtained.mean << " against " << quantity.expected.mean << ", " << quantity.count << " draws");
  CHECK(std::abs(quantity.obtained.mean - quantity.expected.mean) <
        standard_errors * quantity.expected.deviation / std::sqrt(static_cast<double>(quantity.count)));
}

void check_deviation(const QuantityStatistics& quantity) {
  const double error = quantity.expected.deviation / std::sqrt(2 * static_cast<double>(quantity.count));
  CHECK(std::abs(quantity.obtained.deviation - quantity.expected.deviation) < standard_errors * error);
}

}  // namespace

TEST_CASE("cut normal draws have the moments of the cut normal distribution", "[common][natural]") {
  Scatter scatter(7, "moments");
  constexpr int draws = 200000;
  double sum = 0, squares = 0, fourth = 0, greatest = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = scatter.normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
    greatest = std::max(greatest, std::abs(x));
  }
  const Moments expected = moments({0, 1});
  CHECK(expected.mean == Approx(0).margin(1e-15));
  CHECK(expected.deviation == Approx(0.98658).epsilon(1e-5));  // tabulated for a cut at three deviations
  CHECK(greatest <= 3);
  CHECK(std::abs(sum / draws) < standard_errors / std::sqrt(draws));
  CHECK(std::abs(squares / draws - expected.deviation * expected.deviation) <
        standard_errors * std::sqrt(2.0 / draws));
  // E x^4 of the cut distribution: 3 E x^2 - 2 27 phi(3) / (2 Phi(3) - 1), by parts; its own deviation is
  // below 10.
  const double phi = std::exp(-4.5) / std::sqrt(2 * std::numbers::pi),
               share = std::erf(3 / std::numbers::sqrt2);
  CHECK(std::abs(fourth / draws - (3 * expected.deviation * expected.deviation - 54 * phi / share)) <
        standard_errors * 10 / std::sqrt(draws));
}

TEST_CASE("the first draws are the same on every machine", "[common][natural]") {
  Scatter scatter(1, "set");
  const double first = scatter.normal(), second = scatter.normal();
  Scatter again(1, "set"), another(1, "other"), reseeded(2, "set");
  CHECK(again.normal() == first);
  CHECK(again.normal() == second);
  CHECK(another.normal() != first);
  CHECK(reseeded.normal() != first);
  // Computed with another implementation of the generator and of the draw.
  CHECK(first == 2.1433836578767904);
  CHECK(second == 1.6729207755518805);
}

TEST_CASE("positive draws have the moments of a normal distribution cut at zero", "[common][natural]") {
  Scatter scatter(5, "positive");
  const Scattered wide{1, 0.8};
  constexpr int draws = 100000;
  double sum = 0, least = 1;
  for (int i = 0; i < draws; ++i) {
    const double x = scatter.draw_positive(wide);
    sum += x;
    least = std::min(least, x);
  }
  const Moments expected = positive_moments(wide);
  CHECK(least > 0);
  CHECK(expected.mean > 1);
  CHECK(std::abs(sum / draws - expected.mean) < standard_errors * expected.deviation / std::sqrt(draws));
}

TEST_CASE("drawn sets agree with their input as closely as sampling allows, in both readings of persistence",
          "[common][natural]") {
  const auto reading = GENERATE(PersistenceReading::repeat, PersistenceReading::gap);
  const auto seed = GENERATE(range<std::uint64_t>(1, 6));
  for (const auto& [azimuth, spacing, length, persistence] :
       {std::array{90.0, 80.0, 40.0, 80.0}, std::array{330.0, 30.0, 40.0, 50.0}}) {
    const NaturalFractureSet set = set_of(azimuth, spacing, length, persistence, reading, seed);
    const SetStatistics statistics = fissura::statistics(set, draw_traces(set));
    for (const QuantityStatistics& quantity :
         {statistics.orientation, statistics.length, statistics.persistence}) {
      check_mean(quantity);
      check_deviation(quantity);
    }
    check_mean(statistics.spacing);
    CHECK(statistics.length.count > 80);
  }
}

TEST_CASE("number and length of traces per area are unbiased up to the edge of the region",
          "[common][natural]") {
  const auto reading = GENERATE(PersistenceReading::repeat, PersistenceReading::gap);
  constexpr int sets = 60;
  double density = 0, intensity = 0, density_squares = 0, intensity_squares = 0;
  NaturalFractureSet set = set_of(330, 30, 40, 50, reading, 0);
  set.west = set.south = -100;  // five traces across: a bias at the edge would show
  set.east = set.north = 100;
  for (int seed = 0; seed < sets; ++seed) {
    set.seed = static_cast<std::uint64_t>(seed);
    const SetStatistics statistics = fissura::statistics(set, draw_traces(set));
    density += statistics.density / sets;
    intensity += statistics.intensity / sets;
    density_squares += statistics.density * statistics.density / sets;
    intensity_squares += statistics.intensity * statistics.intensity / sets;
  }
  const double density_error = std::sqrt((density_squares - density * density) / sets);
  const double intensity_error = std::sqrt((intensity_squares - intensity * intensity) / sets);
  INFO(density << " +- " << density_error << ", " << intensity << " +- " << intensity_error);
  CHECK(intensity_error <
        0.02 * intensity);  // sharp enough to see a bias of an edge of half a trace length, 20 %
  CHECK(std::abs(density - expected_density(set)) < standard_errors * density_error);
  CHECK(std::abs(intensity - expected_intensity(set)) < standard_errors * intensity_error);
}

TEST_CASE("the gap between traces is longer than their distance by a trace", "[common][natural]") {
  const NaturalFractureSet repeat = set_of(90, 80, 40, 80, PersistenceReading::repeat, 1);
  const NaturalFractureSet gap = set_of(90, 80, 40, 80, PersistenceReading::gap, 1);
  CHECK(mean_repeat(repeat) == Approx(80));
  CHECK(mean_repeat(gap) == Approx(120));
  CHECK(expected_intensity(repeat) == Approx(40.0 / (80 * 80)));
  CHECK(expected_intensity(gap) == Approx(40.0 / (80 * 120)));
}

TEST_CASE("a set without scatter is a regular pattern", "[common][natural]") {
  NaturalFractureSet set = set_of(0, 50, 20, 40, PersistenceReading::repeat, 3);
  set.orientation.deviation = set.spacing.deviation = set.length.deviation = set.persistence.deviation = 0;
  const std::vector<DrawnTrace> traces = draw_traces(set);
  // 1000 / 50 rows of 1000 / 40 traces, and one that is cut at both edges where a row has it.
  CHECK(traces.size() >= 20 * 25);
  CHECK(traces.size() <= 20 * 26);
  const SetStatistics statistics = fissura::statistics(set, traces);
  CHECK(statistics.spacing.obtained.mean == Approx(50).epsilon(1e-9));
  CHECK(statistics.persistence.obtained.mean == Approx(40).epsilon(1e-9));
  CHECK(statistics.orientation.obtained.mean == Approx(0).margin(1e-9));
  for (const DrawnTrace& trace : traces) {
    CHECK(std::abs(trace.begin[0] - trace.end[0]) < 2e-6);  // two steps of the grid of end points
    for (const Point& end : {trace.begin, trace.end})
      CHECK(std::max(std::abs(end[0]), std::abs(end[1])) <= 500);
  }
}
