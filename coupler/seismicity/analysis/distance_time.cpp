// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/analysis/distance_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fissura::coupler {

namespace {

constexpr std::size_t events_of_a_group = 20, fewest_groups = 8, most_groups = 40;
constexpr double share_within = 0.95;
constexpr std::size_t fewest_points = 3;
constexpr double indistinct = 0.03;
constexpr int points_of_a_curve = 60;
constexpr int dimension_of_the_model = 2;

struct Kind {
  const char *name, *meaning;
  double exponent;
};
constexpr Kind diffusion{"diffusion", "pore pressure that spreads, or a fracture governed by leak-off",
                         1.0 / 2};
constexpr Kind kinds[]{diffusion,
                       {"KGD", "a fracture in plane strain without leak-off", 2.0 / 3},
                       {"PKN", "a fracture of given height without leak-off", 4.0 / 5}};

struct Sighting {
  double time, distance;
};

double distance_to_nearest(const std::array<double, 2>& place, const std::vector<Perforation>& perforations) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Perforation& perforation : perforations)
    nearest =
        std::min(nearest, std::hypot(place[0] - perforation.position[0], place[1] - perforation.position[1]));
  return nearest;
}

void take_schedule(const std::vector<Stage>& stages, DistanceTime& result) {
  const auto pumps = [](const Stage& stage) {
    return stage.control == StageControl::pressure || (stage.control == StageControl::rate && stage.rate > 0);
  };
  const auto first = std::find_if(stages.begin(), stages.end(), pumps);
  if (first == stages.end()) return;
  result.start = first->begin;
  const auto end = std::find_if_not(first, stages.end(), pumps);
  if (end != stages.end()) result.shut_in = end->begin;
}

/// While pumping, by time, with positive time and distance.
std::vector<Sighting> sightings(const std::vector<SeismicEvent>& events, const DistanceTime& result) {
  std::vector<Sighting> seen;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double time = events[i].centroid_time;
    const bool pumping = time > result.start && (!result.shut_in || time <= *result.shut_in);
    if (pumping && result.distance[i] > 0) seen.push_back({time, result.distance[i]});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Sighting& a, const Sighting& b) { return a.time < b.time; });
  return seen;
}

DistanceCurve envelope_of(const std::vector<Sighting>& seen) {
  DistanceCurve envelope;
  if (seen.empty()) return envelope;
  const std::size_t groups =
      std::clamp(seen.size() / events_of_a_group, std::min(seen.size(), fewest_groups), most_groups);
  for (std::size_t number = 0; number < groups; ++number) {
    const auto begin = seen.begin() + static_cast<std::ptrdiff_t>(number * seen.size() / groups);
    const auto end = seen.begin() + static_cast<std::ptrdiff_t>((number + 1) * seen.size() / groups);
    std::vector<Sighting> group(begin, end);
    std::stable_sort(group.begin(), group.end(),
                     [](const Sighting& a, const Sighting& b) { return a.distance < b.distance; });
    const auto rank = static_cast<std::size_t>(std::ceil(share_within * static_cast<double>(group.size())));
    envelope.time.push_back(group[rank - 1].time);
    envelope.distance.push_back(group[rank - 1].distance);
  }
  return envelope;
}

template <class Front>
DistanceCurve drawn(double from, double to, const Front& front) {
  DistanceCurve curve;
  for (int i = 0; i <= points_of_a_curve; ++i) {
    curve.time.push_back(from + (to - from) * i / points_of_a_curve);
    curve.distance.push_back(front(curve.time.back()));
  }
  return curve;
}

std::string verdict_on(const DistanceTime& result) {
  if (!result.fit)
    return fmt::format("No law is fitted: the envelope has {} point(s), {} at different times are needed.",
                       result.envelope.time.size(), fewest_points);
  const GrowthLaw& nearest = result.laws[*result.nearest];
  const bool diffusive = result.fits && nearest.name == diffusion.name;
  return fmt::format("{}iffusive: {} (t^{:.3f}, {}).", diffusive ? "D" : "Not d",
                     result.fits ? nearest.name + " fits" : "no law fits, the nearest is " + nearest.name,
                     nearest.law.exponent, nearest.meaning);
}

void fit_laws(double end, DistanceTime& result) {
  std::vector<double> since_start = result.envelope.time;
  for (double& time : since_start) time -= result.start;
  const std::vector<double>& distance = result.envelope.distance;
  for (const Kind& kind : kinds) {
    GrowthLaw& law = result.laws.emplace_back();
    law.name = kind.name;
    law.meaning = kind.meaning;
    law.law.exponent = kind.exponent;
    law.law.coefficient = fitted_coefficient(since_start, distance, kind.exponent);
    law.misfit = misfit(since_start, distance, law.law);
    if (kind.name == diffusion.name) law.diffusivity = diffusivity_of(law.law.coefficient);
    law.curve = drawn(result.start, end, [&](double time) {
      return law.law.coefficient * std::pow(time - result.start, kind.exponent);
    });
  }
  if (since_start.size() < fewest_points) return;
  result.fit = fitted_power_law(since_start, distance);
  if (!result.fit) return;
  const auto least = std::min_element(result.laws.begin(), result.laws.end(),
                                      [](const auto& a, const auto& b) { return a.misfit < b.misfit; });
  result.nearest = static_cast<std::size_t>(least - result.laws.begin());
  result.fits = std::abs(result.fit->exponent - least->law.exponent) <=
                std::max(indistinct, 2 * result.fit->exponent_sigma.value_or(0));
}

}  // namespace

std::optional<DistanceTime> distance_time(const std::vector<SeismicEvent>& events, const Case& run_case) {
  const std::vector<Perforation>& perforations = run_case.injection.perforations;
  if (perforations.empty()) return {};
  DistanceTime result;
  for (const Perforation& perforation : perforations)
    for (std::size_t axis = 0; axis < 2; ++axis)
      result.well[axis] += perforation.position[axis] / static_cast<double>(perforations.size());
  take_schedule(run_case.injection.stages, result);
  double last = result.start;
  for (const SeismicEvent& event : events) {
    result.distance.push_back(distance_to_nearest(event.centroid, perforations));
    last = std::max(last, event.centroid_time);
  }
  result.envelope = envelope_of(sightings(events, result));
  if (!result.envelope.time.empty()) fit_laws(last, result);
  result.verdict = verdict_on(result);
  if (result.shut_in && last > *result.shut_in && !result.laws.empty())
    result.back_front = drawn(*result.shut_in, last, [&](double time) {
      return back_front(*result.laws.front().diffusivity, time - result.start, *result.shut_in - result.start,
                        dimension_of_the_model);
    });
  return result;
}

}  // namespace fissura::coupler
