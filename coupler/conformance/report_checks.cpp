// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/topologies.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 2.2";

/// One row of values for each node or each segment; what they share with PRESSURE is the same.
std::string fields(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(3);
  scene.driver.insert(junction(scene.driver.network(), 2, 2, PumpedSlit::spacing, scene.time));
  scene.advance();
  const ReportedFields reported = scene.driver.report();
  const std::size_t nodes = scene.driver.network().nodes().size();
  const std::size_t segments = scene.driver.network().segments().size();
  std::string names;
  for (const FlowField& field : reported.fields) {
    const std::size_t rows = field.values.size() / std::max<std::size_t>(field.columns.value_or(1), 1);
    require(rows == nodes || rows == segments,
            fmt::format("{}: a row for each of {} nodes or {} segments", field.name, nodes, segments),
            fmt::format("{} rows", rows));
    names += (names.empty() ? "" : ", ") + field.name;
  }
  if (const auto pressure = reported.find("pressure"))
    require_same_bits("pressure in FIELDS of node", *pressure, scene.last.pressure);
  if (const auto filled = reported.find("filled"))
    require_same_bits("filled in FIELDS of node", *filled, scene.last.filled);
  return names.empty() ? "no fields" : names;
}

std::string content(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(3);
  const std::optional<std::vector<double>> told = scene.driver.report().find("content");
  if (!told) return "it does not tell the content";
  constexpr double rounding = 1e-9;
  const double in_fields = water::thickness * integral(scene.driver.network(), *told);
  require_ratio("content of all nodes in FIELDS [m3]", in_fields, scene.last.ledger.in_fractures, rounding);
  return fmt::format("{:.9g} m3 in FIELDS, {:.9g} m3 in the ledger", in_fields,
                     scene.last.ledger.in_fractures);
}

std::string changes_nothing(const Candidate& candidate) {
  PumpedSlit plain(candidate), reporting(candidate);
  for (int k = 0; k < 4; ++k) {
    plain.advance();
    reporting.advance();
    (void)reporting.driver.report();
    (void)reporting.driver.report();
  }
  require_same_bits("pressure of node", reporting.last.pressure, plain.last.pressure);
  require_same_bits("filled of node", reporting.last.filled, plain.last.filled);
  return "the same bits with and without REPORT";
}

std::string before_the_first_interval(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  return fmt::format("{} fields", scene.driver.report().fields.size());
}

}  // namespace

std::vector<Check> report_checks() {
  return {
      {.name = "report.fields",
       .contract = contract,
       .expected =
           "FIELDS has geometry and, by name, finite values for each node or segment, the last pressures too",
       .carry_out = fields},
      {.name = "report.content",
       .contract = contract,
       .expected = "the content that FIELDS tells is that of the ledger",
       .carry_out = content},
      {.name = "report.before_the_first_interval",
       .contract = contract,
       .expected = "REPORT is answered before anything was solved",
       .carry_out = before_the_first_interval},
      {.name = "report.changes_nothing",
       .contract = contract,
       .expected = "answers are the same bits whether REPORT was asked for or not",
       .carry_out = changes_nothing},
  };
}

}  // namespace fissura::coupler::conformance
