// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

/// Figures of a scalar that is known at the coupling times of a run. A coupling time stands for the interval
/// that it ends, so that its weight in a mean is the time since the one before (since 0 for the first).
namespace fissura::coupler {

/// A scalar against time. @pre time.size() == value.size(), time rising strictly from above 0
struct Series {
  std::span<const double> time;  ///< [s]
  std::span<const double> value;
};

/// From `from` to `to` [s], both included up to a rounding error.
struct TimeWindow {
  double from = 0, to = 0;
  [[nodiscard]] bool contains(double time) const;
  /// Whether a run whose last coupling time is `last` has gone through the window.
  [[nodiscard]] bool is_over_at(double last) const;
};

/// The part of a series in a window, with the weights of its times [s].
struct WeightedValues {
  std::vector<double> time, value, weight;
};
WeightedValues cut(const Series& series, const TimeWindow& window);

/// sum w v / sum w. @pre !values.value.empty()
double time_mean(const WeightedValues& values);

/// Linear interpolation; nothing outside the times of the series (up to a rounding error).
std::optional<double> value_at(const Series& series, double time);

/// The first time in the window at which the series, taken as linear between its times, is below `threshold`;
/// the first time of the window if it is below there already. Nothing if it never is.
std::optional<double> first_time_below(const Series& series, const TimeWindow& window, double threshold);

}  // namespace fissura::coupler
