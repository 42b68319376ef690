// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What a case must give: the typed content of expected.toml (docs/case_format.md), in SI.
namespace fissura {

/// How a quantity of history.csv becomes the one number that is judged. Means are weighted with time.
enum class Measure {
  mean_relative_error,  ///< | mean over [from, to] of (obtained / reference - 1) | <= tolerance
  value_at,             ///< | obtained(at) / value - 1 | <= tolerance
  mean,                 ///< mean over [from, to] <= bound
  maximum,              ///< maximum over [from, to] <= bound
  minimum,              ///< minimum over [from, to] >= bound
  time_when_below  ///< | t / expected_time - 1 | <= tolerance, t the first time in [from, to] below `value`
};

/// One [[quantity]]. Members that its measure does not use keep their initial value.
struct ExpectedQuantity {
  std::string name;       ///< column of history.csv, or quantity of a probe
  std::string unit;       ///< unit in which the verdict shows it, as written ("1" if dimensionless)
  double unit_in_si = 1;  ///< one `unit` in SI: shown value = SI value / unit_in_si
  Measure measure = Measure::maximum;
  std::filesystem::path
      reference;             ///< CSV of mean_relative_error (column `time`, then quantities, SI); exists
  double from = 0;           ///< [s]
  double to = 0;             ///< [s], at most the end of the run; its default is the end
  double at = 0;             ///< [s]; of value_at
  double value = 0;          ///< [SI]; of value_at and time_when_below
  double expected_time = 0;  ///< [s]; of time_when_below
  double tolerance = 0;      ///< [-], > 0; of mean_relative_error, value_at and time_when_below
  double bound = 0;          ///< [SI]; `at_most` of mean and maximum, `at_least` of minimum
  std::string reason;        ///< why this tolerance or bound
};

struct Expectations {
  std::vector<ExpectedQuantity> quantities;
};

/// A column that the history of a run has; `unit` is its SI unit, "1" if dimensionless.
struct HistoryColumn {
  std::string name;
  std::string_view unit;
};

/// Name of a measure as in expected.toml, e.g. "value_at".
std::string_view name(Measure measure);

/// Reads an expected.toml of a run that ends at `end_time` [s]. A quantity whose name is not in `columns`, or
/// whose unit has not the dimension of its column, is a fault. Throws CaseFaults with every fault of the
/// file.
Expectations read_expectations(const std::filesystem::path& file, double end_time,
                               std::span<const HistoryColumn> columns);

}  // namespace fissura
