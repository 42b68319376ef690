// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/analysis/analysis_json.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace fissura::coupler {

namespace {

using nlohmann::json;

template <class T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json();
}

json curve_json(const DistanceCurve& curve) {
  return {{"time", curve.time}, {"distance", curve.distance}};
}

json law_json(const GrowthLaw& law) {
  return {{"name", law.name},
          {"meaning", law.meaning},
          {"exponent", law.law.exponent},
          {"coefficient", law.law.coefficient},
          {"diffusivity", or_null(law.diffusivity)},
          {"misfit", law.misfit},
          {"curve", curve_json(law.curve)}};
}

json at_the_end(const MomentBudget& budget) {
  const json series = json_of(budget);
  json last;
  for (const auto& [key, values] : series.items())
    if (key != "time") last[key] = values.back();
  return last;
}

json types_json(const std::vector<SeismicEvent>& events) {
  json types = json::object();
  for (const EventType type : {EventType::shear, EventType::tensile, EventType::closing, EventType::mixed})
    types[name(type)] = std::count_if(events.begin(), events.end(),
                                      [&](const SeismicEvent& event) { return event.type == type; });
  return types;
}

json greatest_magnitude(const std::vector<SeismicEvent>& events) {
  const std::vector<double> magnitudes = magnitudes_of(events);
  const auto greatest = std::max_element(magnitudes.begin(), magnitudes.end());
  return greatest == magnitudes.end() ? json() : json(*greatest);
}

}  // namespace

std::vector<double> magnitudes_of(const std::vector<SeismicEvent>& events) {
  std::vector<double> magnitudes;
  for (const SeismicEvent& event : events)
    if (event.magnitude) magnitudes.push_back(*event.magnitude);
  return magnitudes;
}

json totals_json(const std::vector<SeismicEvent>& events, const SeismicSums& sums) {
  return {{"events", events.size()},
          {"types", types_json(events)},
          {"greatest_magnitude", greatest_magnitude(events)},
          {"event_moment", sums.event_moment},
          {"seismic_sum", sums.seismic_sum},
          {"aseismic_sum", sums.aseismic_sum},
          {"seismic_fraction", or_null(seismic_fraction(sums))},
          {"raw", sums.raw},
          {"aseismic", sums.aseismic}};
}

std::string caption(const Case& run_case, const SeismicSums& sums) {
  const Seismicity& rules = run_case.seismicity;
  const std::optional<double> fraction = seismic_fraction(sums);
  const std::string share =
      fraction ? fmt::format("Seismic fraction {:.3g} of the scalar moments of all sources", *fraction)
               : std::string("No source");
  const std::string rock = rules.failure_rate > 0
                               ? fmt::format("breaking rock is from {:g} m/s on", rules.failure_rate)
                               : std::string("breaking rock always is");
  const std::string radius = rules.cluster_radius > 0 ? fmt::format("{:g} m", rules.cluster_radius)
                                                      : std::string("1.5 element sizes");
  const std::string time = rules.cluster_time > 0
                               ? fmt::format("{:g} s", rules.cluster_time)
                               : std::string("the time of shear waves in the scaled mass over that distance");
  const std::string thickness = rules.thickness == SourceThickness::layer
                                    ? fmt::format("the layer, {:g} m", run_case.domain.thickness)
                                    : std::string("as much as its length");
  return fmt::format(
      "{}; slip is seismic from {:g} m/s and {:g} Pa of stress drop on, {}. One event: sources of "
      "one kind within {} and {}; its thickness is {}.",
      share, rules.slip_rate, rules.stress_drop, rock, radius, time, thickness);
}

json json_of(const FrequencyMagnitude& magnitudes) {
  json b;
  if (magnitudes.b)
    b = {{"value", magnitudes.b->value},
         {"geometric", magnitudes.b->geometric},
         {"sigma_aki", magnitudes.b->sigma_aki},
         {"sigma_shi_bolt", magnitudes.b->sigma_shi_bolt},
         {"method", "maximum likelihood (Aki 1965), unbiased"},
         {"from", magnitudes.b->from},
         {"events", magnitudes.b->events}};
  return {{"bin", magnitudes.histogram.bin},
          {"magnitude", magnitudes.histogram.middle},
          {"incremental", magnitudes.histogram.count},
          {"cumulative", magnitudes.cumulative},
          {"events", magnitudes.events},
          {"completeness", or_null(magnitudes.completeness)},
          {"numerical_floor", magnitudes.numerical_floor},
          {"b", b},
          {"not_reported", magnitudes.b ? json() : json(magnitudes.not_reported)}};
}

json json_of(const DistanceTime& distance) {
  json laws = json::array(), back;
  for (const GrowthLaw& law : distance.laws) laws.push_back(law_json(law));
  if (distance.back_front)
    back = {{"shut_in", *distance.shut_in}, {"curve", curve_json(*distance.back_front)}};
  return {{"well", distance.well},
          {"start", distance.start},
          {"shut_in", or_null(distance.shut_in)},
          {"envelope", curve_json(distance.envelope)},
          {"exponent", distance.fit ? json(distance.fit->exponent) : json()},
          {"exponent_sigma", distance.fit ? or_null(distance.fit->exponent_sigma) : json()},
          {"laws", laws},
          {"best_law", distance.nearest ? json(distance.laws[*distance.nearest].name) : json()},
          {"fits", distance.fits},
          {"verdict", distance.verdict},
          {"back_front", back}};
}

json json_of(const MomentBudget& budget) {
  return {{"time", budget.time},
          {"cumulative", budget.cumulative},
          {"greatest", budget.greatest},
          {"injected", budget.injected},
          {"greatest_bound", budget.greatest_bound},
          {"sum_bound", budget.sum_bound}};
}

json json_of(const EventRate& rate) {
  return {{"time", rate.edge}, {"events", rate.events}, {"moment", rate.moment}};
}

json json_of(const StimulatedVolume& volume) {
  json cells = json::array();
  for (const StimulatedCell& cell : volume.cells)
    cells.push_back({cell.middle[0], cell.middle[1], cell.events});
  return {{"voxel_size", volume.cell_size},
          {"voxel_events", volume.cell_events},
          {"cells", cells},
          {"voxel_volume", volume.cell_volume},
          {"hull", volume.hull},
          {"hull_volume", volume.hull_volume},
          {"thickness", volume.thickness}};
}

json analysis_json(const std::vector<SeismicEvent>& events, const Case& run_case,
                   const InjectedVolume& injected, const SeismicSums& sums) {
  json distance;
  if (const auto found = distance_time(events, run_case)) {
    distance = json_of(*found);
    for (json& law : distance["laws"]) law.erase("curve");
    if (!distance["back_front"].is_null()) distance["back_front"].erase("curve");
  }
  json volume = json_of(stimulated_volume(events, run_case.seismicity, run_case.domain.thickness));
  volume["cells"] = volume["cells"].size();
  return {{"events",
           {{"count", events.size()},
            {"types", types_json(events)},
            {"greatest_magnitude", greatest_magnitude(events)}}},
          {"frequency_magnitude",
           json_of(frequency_magnitude(magnitudes_of(events), numerical_magnitude_floor(run_case)))},
          {"distance", distance},
          {"moment", at_the_end(moment_budget(events, injected, run_case.rock.shear_modulus(),
                                              {std::numeric_limits<double>::infinity()}))},
          {"volume", volume},
          {"caption", caption(run_case, sums)}};
}

}  // namespace fissura::coupler
