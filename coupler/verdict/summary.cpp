// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/verdict/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "coupler/verdict/series.hpp"

namespace fissura::coupler {

namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json quantity_json(const QuantityResult& result) {
  Json json;
  json["name"] = result.name;
  json["measure"] = name(result.measure);
  json["unit"] = result.unit;
  json["expected"] = result.expected;
  json["obtained"] = number_or_null(result.obtained);
  json["relative_error"] = number_or_null(result.relative_error);
  json["tolerance"] = number_or_null(result.tolerance);
  json["pass"] = result.pass;
  if (!result.remark.empty()) json["remark"] = result.remark;
  return json;
}

std::span<const double> column(const History& history, const char* name) {
  return history.series(name).value();
}

/// A value that is not a number is the worst there is: it must not hide behind the others.
double worst(std::span<const double> values) {
  double result = 0;
  for (const double value : values) {
    if (std::isnan(value)) return value;
    result = std::max(result, value);
  }
  return result;
}

double mean(const History& history, const char* name) {
  const auto time = column(history, "time");
  if (time.empty()) return 0;
  return time_mean(cut({time, column(history, name)}, {0, std::numeric_limits<double>::infinity()}));
}

std::uint64_t sum(std::span<const double> values) {
  std::uint64_t result = 0;
  for (const double value : values) result += static_cast<std::uint64_t>(value);
  return result;
}

Json ledger_json(const History& history) {
  const Ledger ledger = history.size() > 0 ? history.last().ledger : Ledger{};
  return {{"injected", ledger.injected},
          {"in_place", ledger.in_place},
          {"found", ledger.found},
          {"in_fractures", ledger.in_fractures},
          {"leaked", ledger.leaked},
          {"reset", ledger.reset},
          {"max_relative_residual", worst(column(history, "relative_residual"))}};
}

Json wall_json(const WallTimes& wall) {
  const double loops = wall.element + wall.joint;
  return {{"total_s", wall.total},
          {"structure_s", wall.structure},
          {"element_s", wall.element},
          {"joint_s", wall.joint},
          {"network_s", wall.network},
          {"coupler_s", wall.coupler},
          {"seismicity_s", wall.seismicity},
          {"waiting_s", wall.waiting},
          {"structure_loops_share", wall.total > 0 ? loops / wall.total : 0}};
}

Json remeshing_json(const RemeshTotals& totals) {
  return {{"insertions", totals.insertions},
          {"median_touched", totals.median_touched},
          {"largest_touched", totals.largest_touched},
          {"untouched_identical", totals.untouched_identical},
          {"smallest_angle", totals.smallest_angle},
          {"smallest_step_ratio", totals.smallest_step_ratio},
          {"wall_s", totals.wall},
          {"largest_mass_error", totals.largest_mass_error},
          {"largest_momentum_error", totals.largest_momentum_error},
          {"strain_energy_jump", totals.strain_energy_jump}};
}

Json natural_fractures_json(const MeetingTotals& meetings, double slip_at_rest, const History& history) {
  const IntervalRecord last = history.size() > 0 ? history.last() : IntervalRecord{};
  const NaturalFractureFigures& figures = last.natural_fractures;
  return {{"met", meetings.met},
          {"crossed", meetings.crossed},
          {"arrested", meetings.met - meetings.crossed},
          {"wetted_length", figures.wetted_length},
          {"slipped_length", figures.slipped_length},
          {"opened_length", figures.opened_length},
          {"greatest_slip", figures.greatest_slip},
          {"slip_distance", figures.slip_distance},
          {"greatest_far_slip", figures.greatest_far_slip},
          {"slip_before_time_0", slip_at_rest},
          {"greatest_junction_pressure", worst(column(history, "junction_pressure"))},
          {"found", last.ledger.found}};
}

Json failure_json(const Failure& failure) {
  return {{"exit_code", static_cast<int>(failure.code)},
          {"code", name(failure.code)},
          {"participant", failure.participant},
          {"interval", failure.interval},
          {"phase", failure.phase},
          {"sentence", failure.sentence}};
}

}  // namespace

nlohmann::ordered_json summary_json(const Verdict& verdict, const History& history,
                                    const RunFigures& figures) {
  Json summary;
  summary["verdict"] = name(figures.failure ? Judgement::fail : verdict.judgement);
  summary["quantities"] = Json::array();
  for (const QuantityResult& result : verdict.quantities)
    summary["quantities"].push_back(quantity_json(result));
  summary["ledger"] = ledger_json(history);
  summary["mismatch"] = {{"mean", mean(history, "mismatch")}, {"max", worst(column(history, "mismatch"))}};
  summary["coupling"] = {{"intervals", history.size()},
                         {"explicit_steps", sum(column(history, "explicit_steps"))},
                         {"insertions", figures.insertions}};
  summary["remeshing"] = remeshing_json(figures.remeshing);
  summary["natural_fractures"] =
      natural_fractures_json(figures.meetings, figures.slip_before_time_0, history);
  summary["seismicity"] = figures.seismicity;
  summary["wall"] = wall_json(figures.wall);
  summary["mesh"] = {{"elements", figures.elements}, {"nodes", figures.nodes}};
  if (figures.failure) summary["failure"] = failure_json(*figures.failure);
  return summary;
}

}  // namespace fissura::coupler
