// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "coupler/seismicity/analysis/distance_time.hpp"
#include "coupler/seismicity/analysis/frequency_magnitude.hpp"
#include "coupler/seismicity/analysis/moment_budget.hpp"
#include "coupler/seismicity/analysis/stimulated_volume.hpp"
#include "coupler/seismicity/extraction.hpp"

/// The analysis of a catalogue as JSON, in SI, tensors in the axes of the case [xx, yy, zz, xy]. What there
/// is none of is null.
namespace fissura::coupler {

/// What a catalogue says about a run, in numbers, for its summary:
///   events               count, types {shear: events, ...}, greatest_magnitude
///   frequency_magnitude  json_of
///   distance             json_of, without the curves of the laws; null in a dry case
///   moment               at the end: cumulative, greatest, injected, greatest_bound, sum_bound
///   volume               json_of, with `cells` as a number
///   caption              caption()
/// `sums` are those of the extraction that made the events, `run_case.seismicity` its thresholds.
nlohmann::json analysis_json(const std::vector<SeismicEvent>& events, const Case& run_case,
                             const InjectedVolume& injected, const SeismicSums& sums);

/// events (their number), types, greatest_magnitude, event_moment, seismic_sum, aseismic_sum,
/// seismic_fraction (of the sums of scalar moments; null without any source), raw, aseismic (tensors)
nlohmann::json totals_json(const std::vector<SeismicEvent>& events, const SeismicSums& sums);

/// The magnitudes of the events that have one, in their order.
std::vector<double> magnitudes_of(const std::vector<SeismicEvent>& events);

/// How the events were made, in sentences that every picture of them needs.
std::string caption(const Case& run_case, const SeismicSums& sums);

/// bin, magnitude, incremental, cumulative, events, completeness, numerical_floor, b {value, geometric,
/// sigma_aki, sigma_shi_bolt, method, from, events}, not_reported
nlohmann::json json_of(const FrequencyMagnitude& magnitudes);

/// well, start, shut_in, envelope {time, distance}, exponent, exponent_sigma, laws [{name, meaning, exponent,
/// coefficient, diffusivity, misfit, curve {time, distance}}], best_law, fits, verdict, back_front {shut_in,
/// curve}. Times of the run.
nlohmann::json json_of(const DistanceTime& distance);

/// time, cumulative, greatest, injected, greatest_bound, sum_bound: arrays of equal length
nlohmann::json json_of(const MomentBudget& budget);

/// time (edges of the parts), events, moment: in each part
nlohmann::json json_of(const EventRate& rate);

/// voxel_size, voxel_events, cells [[x, y, events], ...], voxel_volume, hull [[x, y], ...], hull_volume,
/// thickness
nlohmann::json json_of(const StimulatedVolume& volume);

}  // namespace fissura::coupler
