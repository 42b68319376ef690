// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/natural_fractures/set_statistics.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "common/natural_fractures/planar_segment.hpp"

namespace fissura {

namespace {

void take(QuantityStatistics& quantity, const std::vector<double>& values) {
  quantity.count = values.size();
  if (values.empty()) return;
  const auto count = static_cast<double>(values.size());
  double total = 0, squares = 0;
  for (const double value : values) total += value;
  quantity.obtained.mean = total / count;
  for (const double value : values)
    squares += (value - quantity.obtained.mean) * (value - quantity.obtained.mean);
  if (values.size() > 1) quantity.obtained.deviation = std::sqrt(squares / (count - 1));
}

// An azimuth and its opposite are one strike, so the circle of doubled angles is looked at.
void take_axes(QuantityStatistics& quantity, const std::vector<double>& azimuths, double about) {
  quantity.count = azimuths.size();
  if (azimuths.empty()) return;
  double x = 0, y = 0;
  for (const double azimuth : azimuths) {
    x += std::cos(2 * (azimuth - about));
    y += std::sin(2 * (azimuth - about));
  }
  const double resultant = std::min(1.0, std::hypot(x, y) / static_cast<double>(azimuths.size()));
  quantity.obtained = {about + std::atan2(y, x) / 2, std::sqrt(-2 * std::log(resultant)) / 2};
}

struct Measured {
  std::vector<double> azimuths, lengths, spacings, persistences;
};

Measured measure(const NaturalFractureSet& set, std::span<const DrawnTrace> traces) {
  const StrikeAxes axes = strike_axes(set.orientation.mean);
  Measured measured;
  const DrawnTrace* last = nullptr;
  for (const DrawnTrace& trace : traces) {
    const bool inside = trace.centre[0] >= set.west && trace.centre[0] < set.east &&
                        trace.centre[1] >= set.south && trace.centre[1] < set.north;
    if (!inside) continue;
    measured.azimuths.push_back(trace.azimuth);
    measured.lengths.push_back(trace.length);
    if (last != nullptr && last->row == trace.row) {
      const double apart = dot(difference(trace.centre, last->centre), axes.along);
      measured.persistences.push_back(set.reading == PersistenceReading::repeat
                                          ? apart - (trace.length - last->length) / 2
                                          : apart - (trace.length + last->length) / 2);
    } else if (last != nullptr && last->row + 1 == trace.row) {
      measured.spacings.push_back(dot(difference(trace.centre, last->centre), axes.across));
    }
    last = &trace;
  }
  return measured;
}

}  // namespace

SetStatistics statistics(const NaturalFractureSet& set, std::span<const DrawnTrace> traces) {
  const Measured measured = measure(set, traces);
  SetStatistics result;
  result.set = set.name;
  result.traces = traces.size();
  result.orientation.expected = moments(set.orientation);
  result.spacing.expected = positive_moments(set.spacing);
  result.length.expected = positive_moments(set.length);
  result.persistence.expected = positive_moments(set.persistence);
  take_axes(result.orientation, measured.azimuths, set.orientation.mean);
  take(result.spacing, measured.spacings);
  take(result.length, measured.lengths);
  take(result.persistence, measured.persistences);
  const double area = (set.east - set.west) * (set.north - set.south);
  double total = 0;
  for (const DrawnTrace& trace : traces) total += length(difference(trace.end, trace.begin));
  result.expected_density = expected_density(set);
  result.density = static_cast<double>(measured.lengths.size()) / area;
  result.expected_intensity = expected_intensity(set);
  result.intensity = total / area;
  return result;
}

}  // namespace fissura
