// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/verdict/verdict_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace fissura::coupler {

namespace {

constexpr std::size_t column_count = 8;
using Row = std::array<std::string, column_count>;
constexpr std::array<char, column_count> alignment{'<', '<', '>', '>', '<', '>', '>', '<'};

std::string percent(double ratio) {
  return fmt::format("{:+.2f} %", 100 * ratio);
}

std::string expected_text(const QuantityResult& result) {
  const std::string number = fmt::format("{:.5g}", result.expected);
  if (result.tolerance) return number;
  return fmt::format("{} {}", result.measure == Measure::minimum ? ">=" : "<=", number);
}

Row row_of(const QuantityResult& result) {
  return {result.name,
          std::string(name(result.measure)),
          expected_text(result),
          result.obtained ? fmt::format("{:.5g}", *result.obtained) : "-",
          result.unit == "1" ? "-" : result.unit,
          result.relative_error ? percent(*result.relative_error) : "-",
          result.tolerance ? fmt::format("{:g} %", 100 * *result.tolerance) : "-",
          result.pass ? "pass" : (result.remark.empty() ? "FAIL" : fmt::format("FAIL: {}", result.remark))};
}

}  // namespace

std::string verdict_table(const Verdict& verdict) {
  if (verdict.judgement == Judgement::none) return "verdict: none (nothing was expected)\n";
  std::vector<Row> rows{
      {"quantity", "measure", "expected", "obtained", "unit", "error", "tolerance", "result"}};
  for (const QuantityResult& result : verdict.quantities) rows.push_back(row_of(result));

  std::array<std::size_t, column_count> width{};
  for (const Row& row : rows)
    for (std::size_t column = 0; column + 1 < column_count; ++column)
      width[column] = std::max(width[column], row[column].size());

  std::string text;
  for (const Row& row : rows) {
    for (std::size_t column = 0; column < column_count; ++column)
      text += alignment[column] == '<' ? fmt::format("{:<{}}  ", row[column], width[column])
                                       : fmt::format("{:>{}}  ", row[column], width[column]);
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  const auto passed = std::count_if(verdict.quantities.begin(), verdict.quantities.end(),
                                    [](const QuantityResult& result) { return result.pass; });
  return text + fmt::format("verdict: {} ({} of {} quantities)\n", name(verdict.judgement), passed,
                            verdict.quantities.size());
}

}  // namespace fissura::coupler
