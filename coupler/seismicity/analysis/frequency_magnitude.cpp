// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/analysis/frequency_magnitude.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "coupler/seismicity/analysis/b_value.hpp"
#include "coupler/seismicity/moment_tensor.hpp"

namespace fissura::coupler {

namespace {

constexpr double width_of_bins = 0.1;
constexpr double beyond_curvature = 0.2;
constexpr std::size_t fewest_events = 50;

}  // namespace

MagnitudeHistogram magnitude_histogram(std::span<const double> magnitudes, double bin) {
  MagnitudeHistogram histogram{bin, {}, {}};
  if (magnitudes.empty()) return histogram;
  const auto number = [&](double magnitude) { return std::lround(magnitude / bin); };
  const auto [least, greatest] = std::minmax_element(magnitudes.begin(), magnitudes.end());
  const long first = number(*least), last = number(*greatest);
  for (long place = first; place <= last; ++place)
    histogram.middle.push_back(static_cast<double>(place) * bin);
  histogram.count.resize(histogram.middle.size());
  for (const double magnitude : magnitudes)
    ++histogram.count[static_cast<std::size_t>(number(magnitude) - first)];
  return histogram;
}

std::optional<double> completeness_by_curvature(const MagnitudeHistogram& histogram) {
  if (histogram.count.empty()) return {};
  const auto fullest = std::max_element(histogram.count.rbegin(), histogram.count.rend());
  const auto place = static_cast<std::size_t>(histogram.count.rend() - fullest) - 1;
  return histogram.middle[place] + beyond_curvature;
}

double numerical_magnitude_floor(const Case& run_case) {
  const Rock& rock = run_case.rock;
  const double h = run_case.mesh.tip_size, mu = rock.shear_modulus();
  const double lambda = 2 * mu * rock.poissons_ratio / (1 - 2 * rock.poissons_ratio);
  const double strength =
      tip_strength(rock.tensile_strength, rock.fracture_energy, rock.plane_strain_modulus(), h);
  const bool layer = run_case.seismicity.thickness == SourceThickness::layer;
  const double area = h * (layer ? run_case.domain.thickness : h);
  const double potency = area * 2 * rock.fracture_energy / strength;
  return moment_magnitude(
      scalar_moment({potency * (lambda + 2 * mu), potency * lambda, potency * lambda, 0}));
}

FrequencyMagnitude frequency_magnitude(std::span<const double> magnitudes, double numerical_floor) {
  FrequencyMagnitude result;
  result.histogram = magnitude_histogram(magnitudes, width_of_bins);
  result.cumulative.resize(result.histogram.count.size());
  for (std::size_t place = result.cumulative.size(), above = 0; place-- > 0;)
    result.cumulative[place] = above += result.histogram.count[place];
  result.events = magnitudes.size();
  result.completeness = completeness_by_curvature(result.histogram);
  result.numerical_floor = numerical_floor;
  if (!result.completeness) {
    result.not_reported = "no event has a magnitude";
    return result;
  }
  const double from = std::max(*result.completeness, numerical_floor);
  const MagnitudeSample sample = magnitudes_above(magnitudes, from);
  if (sample.count < fewest_events) {
    result.not_reported = fmt::format(
        "{} of {} events reach Mw {:.2f}, the {}; at least {} are needed", sample.count, result.events, from,
        *result.completeness >= numerical_floor ? "completeness of the catalogue"
                                                : "magnitude of a single element that breaks",
        fewest_events);
    return result;
  }
  const MagnitudeSample binned = binned_magnitudes_above(magnitudes, from, width_of_bins);
  if (!(sample.mean_excess > 0) || !(binned.mean_excess > 0)) {
    result.not_reported = fmt::format("the {} magnitudes from {:.2f} on hardly differ", sample.count, from);
    return result;
  }
  const double b = b_value_unbiased(sample);
  result.b = ReportedBValue{b,
                            b_value_geometric(binned, width_of_bins),
                            standard_error_aki(b, sample.count),
                            standard_error_shi_bolt(b, sample),
                            from,
                            sample.count};
  return result;
}

}  // namespace fissura::coupler
