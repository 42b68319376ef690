// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/verdict/series.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

constexpr double rounding = 1e-9;

double slack(double time) {
  return rounding * std::abs(time);
}

}  // namespace

bool TimeWindow::contains(double time) const {
  return time >= from - slack(from) && time <= to + slack(to);
}

bool TimeWindow::is_over_at(double last) const {
  return last >= to - slack(to);
}

WeightedValues cut(const Series& series, const TimeWindow& window) {
  WeightedValues part;
  double before = 0;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (window.contains(series.time[i])) {
      part.time.push_back(series.time[i]);
      part.value.push_back(series.value[i]);
      part.weight.push_back(series.time[i] - before);
    }
    before = series.time[i];
  }
  return part;
}

double time_mean(const WeightedValues& values) {
  ENSURE(!values.value.empty());
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < values.value.size(); ++i) {
    sum += values.weight[i] * values.value[i];
    total += values.weight[i];
  }
  return sum / total;
}

std::optional<double> value_at(const Series& series, double time) {
  if (series.time.empty()) return std::nullopt;
  const double first = series.time.front(), last = series.time.back();
  if (time < first - slack(first) || time > last + slack(last)) return std::nullopt;
  const auto after = std::lower_bound(series.time.begin(), series.time.end(), time);
  if (after == series.time.end()) return series.value.back();
  const auto i = static_cast<std::size_t>(after - series.time.begin());
  if (i == 0) return series.value.front();
  const double share = (time - series.time[i - 1]) / (series.time[i] - series.time[i - 1]);
  return series.value[i - 1] + share * (series.value[i] - series.value[i - 1]);
}

std::optional<double> first_time_below(const Series& series, const TimeWindow& window, double threshold) {
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (!window.contains(series.time[i]) || !(series.value[i] < threshold)) continue;
    if (i == 0 || !window.contains(series.time[i - 1])) return series.time[i];
    const double share = (series.value[i - 1] - threshold) / (series.value[i - 1] - series.value[i]);
    return series.time[i - 1] + share * (series.time[i] - series.time[i - 1]);
  }
  return std::nullopt;
}

}  // namespace fissura::coupler
