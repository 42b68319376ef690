// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/analysis/b_value.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace fissura::coupler {

namespace {

constexpr double published_factor = 2.30;  // ln 10, as Shi and Bolt print it

}  // namespace

MagnitudeSample magnitudes_above(std::span<const double> magnitudes, double completeness) {
  MagnitudeSample sample;
  double sum = 0;
  for (const double magnitude : magnitudes) {
    if (!(magnitude >= completeness)) continue;
    sum += magnitude - completeness;
    ++sample.count;
  }
  if (sample.count == 0) return sample;
  sample.mean_excess = sum / static_cast<double>(sample.count);
  for (const double magnitude : magnitudes) {
    if (!(magnitude >= completeness)) continue;
    const double deviation = magnitude - completeness - sample.mean_excess;
    sample.square_sum += deviation * deviation;
  }
  return sample;
}

MagnitudeSample binned_magnitudes_above(std::span<const double> magnitudes, double completeness, double bin) {
  std::vector<double> excess;
  for (const double magnitude : magnitudes)
    if (magnitude >= completeness) excess.push_back(bin * std::floor((magnitude - completeness) / bin));
  return magnitudes_above(excess, 0);
}

double b_value_aki(const MagnitudeSample& sample) {
  return std::numbers::log10e / sample.mean_excess;
}

double b_value_unbiased(const MagnitudeSample& sample) {
  const auto count = static_cast<double>(sample.count);
  return b_value_aki(sample) * (count - 1) / count;
}

double b_value_utsu(const MagnitudeSample& binned, double bin) {
  return std::numbers::log10e / (binned.mean_excess + bin / 2);
}

double b_value_geometric(const MagnitudeSample& binned, double bin) {
  return std::log1p(bin / binned.mean_excess) / (bin * std::numbers::ln10);
}

double standard_error_aki(double b, std::size_t count) {
  return b / std::sqrt(static_cast<double>(count));
}

double standard_error_shi_bolt(double b, const MagnitudeSample& sample) {
  const auto count = static_cast<double>(sample.count);
  return published_factor * b * b * std::sqrt(sample.square_sum / (count * (count - 1)));
}

}  // namespace fissura::coupler
