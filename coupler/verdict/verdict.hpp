// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/case/expected.hpp"
#include "coupler/record/history.hpp"

/// Expected against obtained.
namespace fissura::coupler {

/// One expected quantity, judged.
struct QuantityResult {
  std::string name;  ///< column of history.csv
  Measure measure = Measure::value_at;
  std::string unit;                ///< of `expected` and `obtained`
  double expected = 0;             ///< value, bound, time, or (mean_relative_error) mean of the reference
  std::optional<double> obtained;  ///< nothing if the run cannot tell: `remark` says why
  std::optional<double> relative_error;  ///< signed; nothing for bounds
  std::optional<double> tolerance;       ///< on |relative_error|; nothing for bounds
  bool pass = false;
  std::string remark;
};

enum class Judgement {
  pass,
  fail,
  none  ///< nothing was expected
};

/// "pass", "fail", "none".
const char* name(Judgement judgement);

struct Verdict {
  Judgement judgement = Judgement::none;
  std::vector<QuantityResult> quantities;  ///< in the order of expected.toml
};

/// What expected.toml may judge in a run with probes of these names, for read_expectations(): the columns of
/// history.csv and the quantities of the probes (ProbeSeries::series).
std::vector<fissura::HistoryColumn> judgeable_columns(const std::vector<std::string>& probes);

/// Reads every reference that is named, so that a bad one is known before the run. Throws InputError.
void check_references(const Expectations& expectations);

/// Judges every quantity against the series of the run. What cannot be judged - a window without data or that
/// the run did not reach, a value that is not finite, a reference that does not cover the window - fails with
/// a remark.
Verdict judge(const Expectations& expectations, const History& history);

}  // namespace fissura::coupler
