// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/verdict/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "coupler/record/recorded_scalars.hpp"
#include "coupler/verdict/reference_table.hpp"
#include "coupler/verdict/series.hpp"

namespace fissura::coupler {

namespace {

/// Why a quantity cannot be judged.
struct Undecided {
  std::string remark;
};

Series series_of(const ExpectedQuantity& quantity, const History& history) {
  const auto values = history.series(quantity.name);
  if (!values) throw Undecided{fmt::format("the history has no column \"{}\"", quantity.name)};
  return {history.series("time").value(), *values};
}

TimeWindow window_of(const ExpectedQuantity& quantity) {
  return {quantity.from, quantity.to};
}

void require_reached(const Series& series, double time) {
  const double last = series.time.empty() ? 0 : series.time.back();
  if (!TimeWindow{0, time}.is_over_at(last))
    throw Undecided{fmt::format("the run ended at {:.6g} s, before {:.6g} s", last, time)};
}

WeightedValues values_in_window(const ExpectedQuantity& quantity, const Series& series) {
  require_reached(series, quantity.to);
  WeightedValues values = cut(series, window_of(quantity));
  if (values.value.empty())
    throw Undecided{
        fmt::format("no coupling time between {:.6g} s and {:.6g} s", quantity.from, quantity.to)};
  for (std::size_t i = 0; i < values.value.size(); ++i)
    if (!std::isfinite(values.value[i]))
      throw Undecided{fmt::format("the value at {:.6g} s is not finite", values.time[i])};
  return values;
}

void judge_relative_error(QuantityResult& result, double relative_error, double tolerance) {
  result.relative_error = relative_error;
  result.pass = std::abs(relative_error) <= tolerance;
}

void judge_against_reference(const ExpectedQuantity& quantity, const Series& series, QuantityResult& result) {
  const WeightedValues obtained = values_in_window(quantity, series);
  const ReferenceTable table(quantity.reference);
  WeightedValues reference = obtained, error = obtained;
  for (std::size_t i = 0; i < obtained.time.size(); ++i) {
    const auto expected = value_at(table.series(quantity.name), obtained.time[i]);
    if (!expected) throw Undecided{fmt::format("the reference does not reach {:.6g} s", obtained.time[i])};
    if (*expected == 0) throw Undecided{fmt::format("the reference is zero at {:.6g} s", obtained.time[i])};
    reference.value[i] = *expected;
    error.value[i] = obtained.value[i] / *expected - 1;
  }
  result.expected = time_mean(reference) / quantity.unit_in_si;
  result.obtained = time_mean(obtained) / quantity.unit_in_si;
  judge_relative_error(result, time_mean(error), quantity.tolerance);
}

void judge_value_at(const ExpectedQuantity& quantity, const Series& series, QuantityResult& result) {
  result.expected = quantity.value / quantity.unit_in_si;
  require_reached(series, quantity.at);
  const auto value = value_at(series, quantity.at);
  if (!value) throw Undecided{fmt::format("no coupling time up to {:.6g} s", quantity.at)};
  if (!std::isfinite(*value))
    throw Undecided{fmt::format("the value at {:.6g} s is not finite", quantity.at)};
  result.obtained = *value / quantity.unit_in_si;
  judge_relative_error(result, *value / quantity.value - 1, quantity.tolerance);
}

void judge_time_when_below(const ExpectedQuantity& quantity, const Series& series, QuantityResult& result) {
  result.unit = std::string("s");
  result.expected = quantity.expected_time;
  const auto time = first_time_below(series, window_of(quantity), quantity.value);
  if (!time)
    throw Undecided{fmt::format("never below {:.6g} {} between {:.6g} s and {:.6g} s",
                                quantity.value / quantity.unit_in_si, quantity.unit, quantity.from,
                                quantity.to)};
  result.obtained = *time;
  judge_relative_error(result, *time / quantity.expected_time - 1, quantity.tolerance);
}

void judge_bound(const ExpectedQuantity& quantity, const Series& series, QuantityResult& result) {
  result.expected = quantity.bound / quantity.unit_in_si;
  const WeightedValues values = values_in_window(quantity, series);
  double obtained = 0;
  if (quantity.measure == Measure::mean) obtained = time_mean(values);
  if (quantity.measure == Measure::maximum)
    obtained = *std::max_element(values.value.begin(), values.value.end());
  if (quantity.measure == Measure::minimum)
    obtained = *std::min_element(values.value.begin(), values.value.end());
  result.obtained = obtained / quantity.unit_in_si;
  result.pass =
      quantity.measure == Measure::minimum ? obtained >= quantity.bound : obtained <= quantity.bound;
}

bool is_bound(Measure measure) {
  return measure == Measure::mean || measure == Measure::maximum || measure == Measure::minimum;
}

void judge_measure(const ExpectedQuantity& quantity, const Series& series, QuantityResult& result) {
  switch (quantity.measure) {
    case Measure::mean_relative_error:
      return judge_against_reference(quantity, series, result);
    case Measure::value_at:
      return judge_value_at(quantity, series, result);
    case Measure::time_when_below:
      return judge_time_when_below(quantity, series, result);
    case Measure::mean:
    case Measure::maximum:
    case Measure::minimum:
      return judge_bound(quantity, series, result);
  }
}

QuantityResult judge_quantity(const ExpectedQuantity& quantity, const History& history) {
  QuantityResult result;
  result.name = quantity.name;
  result.measure = quantity.measure;
  result.unit = quantity.unit;
  if (!is_bound(quantity.measure)) result.tolerance = quantity.tolerance;
  try {
    judge_measure(quantity, series_of(quantity, history), result);
  } catch (const Undecided& undecided) {
    result.remark = undecided.remark;
  } catch (const InputError& error) {
    result.remark = error.what();
  }
  return result;
}

}  // namespace

const char* name(Judgement judgement) {
  switch (judgement) {
    case Judgement::pass:
      return "pass";
    case Judgement::fail:
      return "fail";
    case Judgement::none:
      return "none";
  }
  return "unknown";
}

std::vector<fissura::HistoryColumn> judgeable_columns(const std::vector<std::string>& probes) {
  std::vector<fissura::HistoryColumn> columns;
  for (const RecordedScalar& scalar : recorded_scalars())
    columns.push_back({std::string(scalar.name), scalar.unit});
  for (const ProbeColumn& column : probe_columns(probes)) columns.push_back({column.name, column.unit});
  return columns;
}

void check_references(const Expectations& expectations) {
  for (const ExpectedQuantity& quantity : expectations.quantities)
    if (quantity.measure == Measure::mean_relative_error)
      (void)ReferenceTable(quantity.reference).series(quantity.name);
}

Verdict judge(const Expectations& expectations, const History& history) {
  Verdict verdict;
  for (const ExpectedQuantity& quantity : expectations.quantities)
    verdict.quantities.push_back(judge_quantity(quantity, history));
  if (verdict.quantities.empty()) return verdict;
  const bool all_pass = std::all_of(verdict.quantities.begin(), verdict.quantities.end(),
                                    [](const QuantityResult& result) { return result.pass; });
  verdict.judgement = all_pass ? Judgement::pass : Judgement::fail;
  return verdict;
}

}  // namespace fissura::coupler
