// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/analysis/moment_budget.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::coupler {

namespace {

constexpr double minute = 60;
constexpr std::size_t fewest_parts = 20;

}  // namespace

double injected_until(const InjectedVolume& injected, double time) {
  double before = 0, volume_before = 0, greatest = 0;
  for (std::size_t i = 0; i < injected.time.size(); ++i) {
    if (injected.time[i] > time) {
      const double share = std::max(0.0, time - before) / (injected.time[i] - before);
      return std::max(greatest, volume_before + share * (injected.volume[i] - volume_before));
    }
    before = injected.time[i];
    volume_before = injected.volume[i];
    greatest = std::max(greatest, volume_before);
  }
  return greatest;
}

double greatest_moment_bound(double shear_modulus, double volume) {
  return shear_modulus * volume;
}

double moment_sum_bound(double shear_modulus, double volume) {
  return 2 * shear_modulus * volume;
}

MomentBudget moment_budget(const std::vector<SeismicEvent>& events, const InjectedVolume& injected,
                           double shear_modulus, const std::vector<double>& times) {
  std::vector<const SeismicEvent*> order;
  for (const SeismicEvent& event : events) order.push_back(&event);
  std::stable_sort(order.begin(), order.end(), [](const SeismicEvent* a, const SeismicEvent* b) {
    return a->centroid_time < b->centroid_time;
  });
  MomentBudget budget;
  budget.time = times;
  double sum = 0, greatest = 0;
  auto next = order.begin();
  for (const double time : times) {
    for (; next != order.end() && (*next)->centroid_time <= time; ++next) {
      sum += (*next)->scalar_moment;
      greatest = std::max(greatest, (*next)->scalar_moment);
    }
    const double volume = injected_until(injected, time);
    budget.cumulative.push_back(sum);
    budget.greatest.push_back(greatest);
    budget.injected.push_back(volume);
    budget.greatest_bound.push_back(greatest_moment_bound(shear_modulus, volume));
    budget.sum_bound.push_back(moment_sum_bound(shear_modulus, volume));
  }
  return budget;
}

EventRate event_rate(const std::vector<SeismicEvent>& events, double end) {
  const auto minutes = static_cast<std::size_t>(std::ceil(end / minute));
  const bool by_minutes = minutes >= fewest_parts;
  const std::size_t parts = by_minutes ? minutes : fewest_parts;
  const double width = by_minutes ? minute : end / static_cast<double>(parts);
  EventRate rate;
  for (std::size_t part = 0; part <= parts; ++part) rate.edge.push_back(static_cast<double>(part) * width);
  rate.events.resize(parts);
  rate.moment.resize(parts);
  for (const SeismicEvent& event : events) {
    const auto part = static_cast<std::size_t>(
        std::clamp(event.centroid_time / width, 0.0, static_cast<double>(parts - 1)));
    ++rate.events[part];
    rate.moment[part] += event.scalar_moment;
  }
  return rate;
}

}  // namespace fissura::coupler
