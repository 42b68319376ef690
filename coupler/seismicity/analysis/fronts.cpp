// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/analysis/fronts.hpp"

#include <cmath>
#include <numbers>

namespace fissura::coupler {

double triggering_front(double diffusivity, double time) {
  return std::sqrt(4 * std::numbers::pi * diffusivity * time);
}

double back_front(double diffusivity, double time, double shut_in, int dimension) {
  if (time <= shut_in) return 0;
  return std::sqrt(2 * dimension * diffusivity * time * (time / shut_in - 1) *
                   std::log(time / (time - shut_in)));
}

std::optional<PowerLaw> fitted_power_law(std::span<const double> times, std::span<const double> distances) {
  const std::size_t points = times.size();
  double mean_time = 0, mean_distance = 0;
  for (std::size_t i = 0; i < points; ++i) {
    mean_time += std::log(times[i]) / static_cast<double>(points);
    mean_distance += std::log(distances[i]) / static_cast<double>(points);
  }
  double times_squared = 0, product = 0, least = 0, greatest = 0;
  for (std::size_t i = 0; i < points; ++i) {
    const double time = std::log(times[i]) - mean_time;
    times_squared += time * time;
    product += time * (std::log(distances[i]) - mean_distance);
    least = i == 0 ? times[i] : std::min(least, times[i]);
    greatest = i == 0 ? times[i] : std::max(greatest, times[i]);
  }
  if (!(greatest > least)) return {};
  PowerLaw law;
  law.exponent = product / times_squared;
  law.coefficient = std::exp(mean_distance - law.exponent * mean_time);
  if (points > 2) {
    const double deviation = misfit(times, distances, law);
    const auto count = static_cast<double>(points);
    law.exponent_sigma = deviation * std::sqrt(count / (count - 2) / times_squared);
  }
  return law;
}

double fitted_coefficient(std::span<const double> times, std::span<const double> distances, double exponent) {
  double sum = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    sum += std::log(distances[i]) - exponent * std::log(times[i]);
  return std::exp(sum / static_cast<double>(times.size()));
}

double misfit(std::span<const double> times, std::span<const double> distances, const PowerLaw& law) {
  double sum = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double deviation =
        std::log(distances[i]) - std::log(law.coefficient) - law.exponent * std::log(times[i]);
    sum += deviation * deviation;
  }
  return std::sqrt(sum / static_cast<double>(times.size()));
}

double diffusivity_of(double coefficient) {
  return coefficient * coefficient / (4 * std::numbers::pi);
}

}  // namespace fissura::coupler
