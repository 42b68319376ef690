// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "coupler/seismicity/analysis/b_value.hpp"
#include "coupler/seismicity/analysis/frequency_magnitude.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

/// Magnitudes at the middles of `count` equal shares of the law.
std::vector<double> quantiles(std::size_t count, double b, double from) {
  std::vector<double> magnitudes;
  for (std::size_t i = 1; i <= count; ++i)
    magnitudes.push_back(from -
                         std::log10(1 - (static_cast<double>(i) - 0.5) / static_cast<double>(count)) / b);
  return magnitudes;
}

/// Draws from the law by inversion.
std::vector<double> drawn(std::size_t count, double b, double from, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> magnitudes(count);
  for (double& magnitude : magnitudes) {
    const double uniform = (static_cast<double>(generator() >> 11) + 0.5) * 0x1p-53;
    magnitude = from - std::log10(uniform) / b;
  }
  return magnitudes;
}

struct Spread {
  double mean = 0, deviation = 0;
};

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  for (const double value : values) spread.mean += value / static_cast<double>(values.size());
  for (const double value : values)
    spread.deviation += std::pow(value - spread.mean, 2) / static_cast<double>(values.size() - 1);
  spread.deviation = std::sqrt(spread.deviation);
  return spread;
}

/// The paper's shale with elements of 1 m in a layer of 10 m.
Case shale() {
  Case value;
  value.rock.youngs_modulus = 32e9;
  value.rock.poissons_ratio = 0.2;
  value.rock.tensile_strength = 1e6;
  value.rock.fracture_energy = 50;
  value.mesh.tip_size = 1;
  value.domain.thickness = 10;
  return value;
}

}  // namespace

TEST_CASE("b-value: quantiles of the law give the b of Aki and both standard errors in closed form",
          "[coupler][seismicity][analysis]") {
  const MagnitudeSample sample = magnitudes_above(quantiles(1000, 1, -3), -3);
  CHECK(sample.count == 1000);
  // Thousand additions of numbers of order one.
  CHECK(-3 + sample.mean_excess == Approx(-2.565856014998977).epsilon(1e-13));
  const double b = b_value_aki(sample);
  CHECK(b == Approx(1.000346652).epsilon(5e-10));  // as many digits as the reference has
  CHECK(b_value_unbiased(sample) == Approx(b * 0.999).epsilon(1e-15));
  CHECK(standard_error_aki(b, sample.count) == Approx(0.0316337).epsilon(2e-6));
  CHECK(standard_error_shi_bolt(b, sample) == Approx(0.0315362).epsilon(2e-6));
}

TEST_CASE("b-value: binned quantiles of a geometric law are recovered by its estimator, not by Utsu's",
          "[coupler][seismicity][analysis]") {
  // The mean excess of the geometric law q^k (1 - q) with q = 10^(-b bin) is bin q / (1 - q).
  const double b = 2, bin = 0.1, q = std::pow(10, -b * bin);
  const MagnitudeSample exact{1000, bin * q / (1 - q), 0};
  CHECK(b_value_geometric(exact, bin) == Approx(b).epsilon(1e-13));
  CHECK(b_value_utsu(exact, bin) == Approx(1.9654).epsilon(3e-5));
}

TEST_CASE("b-value: random catalogues lie within three standard errors in 99 % of draws",
          "[coupler][seismicity][analysis]") {
  const double b = GENERATE(0.8, 1.0, 1.5, 2.0);
  const std::size_t count = 10000, draws = 100;
  std::size_t within = 0;
  std::vector<double> found;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const MagnitudeSample sample = magnitudes_above(drawn(count, b, -3, seed), -3);
    found.push_back(b_value_unbiased(sample));
    if (std::abs(found.back() - b) <= 3 * standard_error_aki(b, count)) ++within;
  }
  CHECK(within >= 99);
  const Spread spread = spread_of(found);
  const double expected_error = standard_error_aki(b, count);
  CHECK(std::abs(spread.mean - b) < 3 * expected_error / std::sqrt(draws));
  // The standard deviation of a standard deviation from n draws is 1 / sqrt(2 (n - 1)) of it.
  CHECK(std::abs(spread.deviation / expected_error - 1) < 3 / std::sqrt(2.0 * (draws - 1)));
}

TEST_CASE("b-value: the factor (N - 1) / N removes the bias of Aki in small catalogues",
          "[coupler][seismicity][analysis]") {
  const std::size_t count = 20, draws = 4000;
  std::vector<double> raw, unbiased;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const MagnitudeSample sample = magnitudes_above(drawn(count, 1, 0, seed), 0);
    raw.push_back(b_value_aki(sample));
    unbiased.push_back(b_value_unbiased(sample));
  }
  const double three_errors = 3 * spread_of(raw).deviation / std::sqrt(draws);
  CHECK(std::abs(spread_of(unbiased).mean - 1) < three_errors);
  CHECK(std::abs(spread_of(raw).mean - 20.0 / 19) < three_errors);  // N / (N - 1)
  CHECK(20.0 / 19 - 1 > three_errors);                              // so the two are told apart
}

TEST_CASE("b-value: in bins of 0.1 Utsu is 1.7 % low at b = 2, the geometric estimator is not",
          "[coupler][seismicity][analysis]") {
  const double b = 2, bin = 0.1;
  const std::size_t count = 10000, draws = 100;
  std::vector<double> utsu, geometric;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const MagnitudeSample binned = binned_magnitudes_above(drawn(count, b, -3, seed), -3, bin);
    utsu.push_back(b_value_utsu(binned, bin));
    geometric.push_back(b_value_geometric(binned, bin));
  }
  const double three_errors = 3 * standard_error_aki(b, count) / std::sqrt(draws);
  CHECK(std::abs(spread_of(geometric).mean - b) < three_errors);
  CHECK(std::abs(spread_of(utsu).mean - 1.9654) < three_errors);
  CHECK(b - spread_of(utsu).mean > 3 * three_errors);
}

TEST_CASE("b-value: a cut catalogue has the same b and completeness above the fullest bin",
          "[coupler][seismicity][analysis]") {
  // Below -0.95 nine of ten events are lost, so the fullest bin is the one at -0.9.
  std::vector<double> magnitudes;
  std::size_t number = 0;
  for (const double magnitude : quantiles(20000, 1, -1.55))
    if (magnitude >= -0.95 || ++number % 10 == 0) magnitudes.push_back(magnitude);
  const FrequencyMagnitude found = frequency_magnitude(magnitudes, -4);
  REQUIRE(found.completeness.has_value());
  CHECK(*found.completeness == Approx(-0.9 + 0.2));
  REQUIRE(found.b.has_value());
  CHECK(found.b->from == *found.completeness);
  CHECK(std::abs(found.b->value - 1) < 0.01);  // of quantiles: no scatter, only the ends of the sample
  CHECK(std::abs(found.b->geometric - 1) < 0.01);
  CHECK(found.not_reported.empty());
  CHECK(found.events == magnitudes.size());
  CHECK(found.cumulative.front() == magnitudes.size());
  CHECK(found.cumulative.back() == found.histogram.count.back());
}

TEST_CASE("b-value: below the magnitude of one element nothing is used", "[coupler][seismicity][analysis]") {
  const std::vector<double> magnitudes = quantiles(1000, 1, -3);
  const FrequencyMagnitude found = frequency_magnitude(magnitudes, -2.2);
  REQUIRE(found.b.has_value());
  CHECK(found.b->from == -2.2);
  CHECK(found.b->events == 158);  // 1000 * 10^-0.8
  const FrequencyMagnitude none = frequency_magnitude(magnitudes, -1.5);
  CHECK_FALSE(none.b.has_value());
  CHECK(none.not_reported ==
        "32 of 1000 events reach Mw -1.50, the magnitude of a single element that breaks; at least 50 are "
        "needed");
}

TEST_CASE("b-value: not reported of too few, equal or no magnitudes, and the reason is told",
          "[coupler][seismicity][analysis]") {
  CHECK(frequency_magnitude({}, -3).not_reported == "no event has a magnitude");
  CHECK_FALSE(frequency_magnitude({}, -3).completeness.has_value());
  const std::vector<double> one{-1.234};
  const FrequencyMagnitude single = frequency_magnitude(one, -3);
  CHECK(*single.completeness == Approx(-1.0));
  CHECK(single.histogram.count == std::vector<std::size_t>{1});
  CHECK(single.not_reported ==
        "0 of 1 events reach Mw -1.00, the completeness of the catalogue; at least 50 are needed");
  CHECK_FALSE(frequency_magnitude(std::vector<double>(500, -1.234), -3).b.has_value());
  std::vector<double> equal(60, 0.2);
  equal.insert(equal.end(), 100, 0.0);  // completeness 0.2, then
  const FrequencyMagnitude same = frequency_magnitude(equal, -3);
  CHECK_FALSE(same.b.has_value());
  CHECK(same.not_reported == "the 60 magnitudes from 0.20 on hardly differ");
}

TEST_CASE("numerical floor: one element of the paper's shale that opens fully has Mw -1.116",
          "[coupler][seismicity][analysis]") {
  CHECK(numerical_magnitude_floor(shale()) == Approx(-1.11602).epsilon(5e-6));
  Case fine = shale();
  fine.mesh.tip_size = 0.1;
  CHECK(numerical_magnitude_floor(fine) == Approx(-1.11602 - 2.0 / 3).epsilon(1e-5));
  fine.seismicity.thickness = SourceThickness::equidimensional;  // 0.1 m instead of 10 m
  CHECK(numerical_magnitude_floor(fine) == Approx(-1.11602 - 2.0 / 3 - 4.0 / 3).epsilon(1e-5));
}

TEST_CASE("numerical floor: a strength lowered for coarse elements opens farther",
          "[coupler][seismicity][analysis]") {
  Case coarse = shale();
  coarse.mesh.tip_size = 4;  // sqrt(E' G_f / (1.5 h)) = 0.527 MPa
  const double strength = std::sqrt(coarse.rock.plane_strain_modulus() * 50 / 6);
  CHECK(numerical_magnitude_floor(coarse) - numerical_magnitude_floor(shale()) ==
        Approx(2.0 / 3 * std::log10(4 * 1e6 / strength)).epsilon(1e-12));
}
