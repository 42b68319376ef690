// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/event_of_sources.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "coupler/seismicity/compensated_sum.hpp"

namespace fissura::coupler {

namespace {

constexpr double rounding = 1e-12;  // of the scalar sum

/// Weights of the sources in means: their scalar sums, or one each if all of these are 0.
std::vector<double> weights_of(const std::vector<Source>& sources, double scalar_sum) {
  std::vector<double> weights;
  weights.reserve(sources.size());
  for (const Source& source : sources) weights.push_back(scalar_sum > 0 ? source.scalar_sum : 1);
  return weights;
}

/// Unit normal along the major axis of the sum of n n^T; of the two the one to the side of (1, -1), as the
/// strike of a vertical plane has it.
std::array<double, 2> mean_normal(const std::array<double, 3>& plane) {
  const double angle = 0.5 * std::atan2(plane[2], 0.5 * (plane[0] - plane[1]));
  const double x = std::cos(angle), y = std::sin(angle);
  const bool turned = std::abs(x - y) < rounding ? x > 0 : x < y;
  return turned ? std::array{-x, -y} : std::array{x, y};
}

struct Totals {
  TensorSum moment, pseudo_moment;
  CompensatedSum scalar_sum;
};

void set_moments(SeismicEvent& event, const std::vector<Source>& sources) {
  Totals totals;
  for (const Source& source : sources) {
    totals.moment.add(source.moment);
    totals.pseudo_moment.add(source.pseudo_moment);
    totals.scalar_sum.add(source.scalar_sum);
  }
  event.moment = totals.moment.value();
  event.pseudo_moment = totals.pseudo_moment.value();
  event.scalar_sum = totals.scalar_sum.value();
}

void set_times_and_counts(SeismicEvent& event, const std::vector<Source>& sources,
                          const std::vector<double>& weights) {
  const auto first = std::min_element(sources.begin(), sources.end(),
                                      [](const Source& a, const Source& b) { return a.begin < b.begin; });
  event.origin_time = first->begin;
  event.origin = first->position;
  CompensatedSum weight, time, x, y;
  double end = first->end, pressure = 0;
  event.element_size = first->smallest_size;
  std::map<std::pair<SourceFracture, std::uint32_t>, double> lines;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Source& source = sources[i];
    weight.add(weights[i]);
    time.add(weights[i] * (source.centroid_time - event.origin_time));
    x.add(weights[i] * (source.position[0] - event.origin[0]));
    y.add(weights[i] * (source.position[1] - event.origin[1]));
    lines[{source.fracture, source.line}] += weights[i];
    end = std::max(end, source.end);
    pressure += source.pressure_sum;
    event.element_size = std::min(event.element_size, source.smallest_size);
    event.peak_rate = std::max(event.peak_rate, source.peak_rate);
    event.radius_of_clustering = std::max(event.radius_of_clustering, source.cluster_radius);
    event.time_of_clustering = std::max(event.time_of_clustering, source.cluster_time);
    event.records += source.records;
    event.interval = std::max(event.interval, source.interval);
  }
  event.duration = end - event.origin_time;
  event.centroid_time = event.origin_time + time.value() / weight.value();
  event.centroid = {event.origin[0] + x.value() / weight.value(),
                    event.origin[1] + y.value() / weight.value()};
  event.fluid_pressure = pressure / static_cast<double>(event.records);
  const auto greatest = std::max_element(lines.begin(), lines.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
  event.fracture = greatest->first.first;
  event.line = greatest->first.second;
}

void set_extent(SeismicEvent& event, const std::vector<Source>& sources, const std::vector<double>& weights) {
  std::array<double, 3> plane{};
  for (const Source& source : sources)
    for (std::size_t k = 0; k < plane.size(); ++k) plane[k] += source.plane[k];
  event.normal = mean_normal(plane);
  const auto [nx, ny] = event.normal;
  double weight = 0, second_moment = 0, lowest = 0, highest = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const double x = sources[i].position[0] - event.centroid[0];
    const double y = sources[i].position[1] - event.centroid[1];
    weight += weights[i];
    second_moment += weights[i] * (x * x + y * y);
    const double along = x * ny - y * nx;
    const double half = 0.5 * sources[i].length;
    lowest = i == 0 ? along - half : std::min(lowest, along - half);
    highest = i == 0 ? along + half : std::max(highest, along + half);
  }
  event.radius = std::max(std::sqrt(second_moment / weight), 0.5 * event.element_size);
  event.length = highest - lowest;
}

void set_means_over_area(SeismicEvent& event, const std::vector<Source>& sources) {
  struct Patch {
    double area = 0, slip = 0, opening = 0, drop = 0;
  };
  std::map<Entity, Patch> patches;
  for (const Source& source : sources) {
    Patch& patch = patches[source.entity()];
    patch.area = std::max(patch.area, source.area);
    patch.slip += source.slip;
    patch.opening += source.opening;
    patch.drop += source.shear_drop();
  }
  event.sources = patches.size();
  CompensatedSum area, slip, opening, drop;
  for (const auto& [entity, patch] : patches) {
    area.add(patch.area);
    slip.add(patch.area * patch.slip);
    opening.add(patch.area * patch.opening);
    drop.add(patch.area * patch.drop);
  }
  event.area = area.value();
  event.slip = slip.value() / event.area;
  event.opening = opening.value() / event.area;
  event.stress_drop = drop.value() / event.area;
}

void scale_to_thickness(SeismicEvent& event, const SourceRules& rules) {
  event.thickness = rules.thickness;
  if (rules.thresholds.thickness == SourceThickness::layer) return;
  event.thickness = event.length;
  const double factor = event.length / rules.thickness;
  for (double& component : event.moment) component *= factor;
  for (double& component : event.pseudo_moment) component *= factor;
  event.scalar_sum *= factor;
  event.area *= factor;
}

void set_planes(SeismicEvent& event, const PrincipalMoments& principal, const Geography& geography) {
  const auto [nx, ny] = event.normal;
  const std::array<double, 3> normal{nx, ny, 0};
  const double smallest = rounding * event.scalar_sum;
  if (event.coherence > 0 && principal.value[0] > smallest && principal.value[2] < -smallest) {
    const auto planes = nodal_planes(principal, normal, geography);
    event.plane = planes[0];
    event.auxiliary_plane = planes[1];
    return;
  }
  const auto [xx, yy, zz, xy] = event.moment;
  const double along = nx * ny * (xx - yy) + (ny * ny - nx * nx) * xy;
  const double sign = along > smallest ? 1 : -1;
  const std::array<double, 3> slip{sign * ny, -sign * nx, 0};
  event.plane = nodal_plane(normal, slip, geography);
  event.auxiliary_plane = nodal_plane(slip, normal, geography);
}

}  // namespace

const char* name(EventType type) {
  switch (type) {
    case EventType::shear:
      return "shear";
    case EventType::tensile:
      return "tensile";
    case EventType::closing:
      return "closing";
    case EventType::mixed:
      break;
  }
  return "mixed";
}

EventType event_type(const Decomposition& shares) {
  if (shares.iso > 0.2 && shares.clvd > 0.2) return EventType::tensile;
  if (shares.iso < -0.2 && shares.clvd < -0.2) return EventType::closing;
  if (shares.dc > 0.6) return EventType::shear;
  return EventType::mixed;
}

SeismicEvent event_of(const std::vector<Source>& sources, const SourceRules& rules,
                      const Geography& geography) {
  SeismicEvent event;
  set_moments(event, sources);
  const std::vector<double> weights = weights_of(sources, event.scalar_sum);
  set_times_and_counts(event, sources, weights);
  set_extent(event, sources, weights);
  set_means_over_area(event, sources);
  scale_to_thickness(event, rules);

  const PrincipalMoments principal = principal_moments(event.moment);
  const double scalar = scalar_moment(event.moment);
  if (scalar > rounding * event.scalar_sum) {
    event.scalar_moment = scalar;
    event.coherence = scalar / event.scalar_sum;
    event.magnitude = moment_magnitude(scalar);
    event.shares = decomposition(principal);
    event.hudson = hudson_point(principal);
    event.slope = slope_angle(principal);
    event.type = event_type(event.shares);
  }
  set_planes(event, principal, geography);
  return event;
}

}  // namespace fissura::coupler
