// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/expected.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/case/polyline_file.hpp"
#include "common/case/table_reader.hpp"
#include "common/case/toml_document.hpp"

namespace fissura {

namespace {

using input::TableReader;

constexpr std::array measures{Named<Measure>{"mean_relative_error", Measure::mean_relative_error},
                              Named<Measure>{"value_at", Measure::value_at},
                              Named<Measure>{"mean", Measure::mean},
                              Named<Measure>{"maximum", Measure::maximum},
                              Named<Measure>{"minimum", Measure::minimum},
                              Named<Measure>{"time_when_below", Measure::time_when_below}};

/// The run whose quantities are judged.
struct Run {
  std::filesystem::path folder;
  double end;
  std::span<const HistoryColumn> columns;
};

const HistoryColumn* column_of(const Run& run, const std::string& name) {
  const auto column = std::find_if(run.columns.begin(), run.columns.end(),
                                   [&](const HistoryColumn& candidate) { return candidate.name == name; });
  return column == run.columns.end() ? nullptr : &*column;
}

void read_name(TableReader& table, const Run& run, ExpectedQuantity& quantity) {
  std::vector<std::string> names;
  for (const HistoryColumn& column : run.columns) names.push_back(column.name);
  quantity.name = names.empty() ? table.text("name") : table.word("name", names);
}

void read_unit(TableReader& table, const Run& run, ExpectedQuantity& quantity) {
  quantity.unit = table.text("unit");
  const HistoryColumn* column = column_of(run, quantity.name);
  if (quantity.unit.empty() || column == nullptr) return;
  try {
    if ((quantity.unit == "1") != (column->unit == "1")) throw InputError("dimensionless");
    if (quantity.unit != "1") quantity.unit_in_si = input::unit_in_si(quantity.unit, {"", column->unit, ""});
  } catch (const InputError&) {
    table.refuse("unit", fmt::format("a unit of {}, which is \"{}\" in SI", quantity.name, column->unit));
  }
}

/// A value of the quantity: a bare number if it is dimensionless, text with a unit otherwise.
double read_value(TableReader& table, const Run& run, const ExpectedQuantity& quantity,
                  std::string_view key) {
  const HistoryColumn* column = column_of(run, quantity.name);
  const std::string si(column == nullptr ? std::string_view(quantity.unit) : column->unit);
  if (si.empty() || si == "1") return table.number(key, input::any_value);
  const std::string example = "1 " + quantity.unit;
  return table.quantity(key, {"a value", si, example}, input::any_value);
}

void read_reference(TableReader& table, const Run& run, ExpectedQuantity& quantity) {
  const std::string name = table.text("reference");
  if (name.empty()) return;
  try {
    quantity.reference = input::inside(run.folder, name);
  } catch (const InputError& error) {
    table.refuse("reference", error.what());
  }
}

void read_period(TableReader& table, const Run& run, ExpectedQuantity& quantity) {
  const input::Range within = input::from_to(0, run.end);
  quantity.from = table.quantity("from", input::dimension::time, within, 0.0);
  quantity.to = table.quantity("to", input::dimension::time, within, run.end);
  if (quantity.from >= quantity.to) table.refuse("from", fmt::format("earlier than to, {} s", quantity.to));
}

void read_measure(TableReader& table, const Run& run, ExpectedQuantity& quantity) {
  using input::positive;
  const auto relative_tolerance = [&] { return table.number("tolerance", positive); };
  if (quantity.measure != Measure::value_at) read_period(table, run, quantity);
  switch (quantity.measure) {
    case Measure::mean_relative_error:
      read_reference(table, run, quantity);
      quantity.tolerance = relative_tolerance();
      break;
    case Measure::value_at:
      quantity.at = table.quantity("at", input::dimension::time, input::from_to(0, run.end));
      quantity.value = read_value(table, run, quantity, "value");
      if (quantity.value == 0) table.refuse("value", "not zero, since the tolerance is relative to it");
      quantity.tolerance = relative_tolerance();
      break;
    case Measure::mean:
    case Measure::maximum:
      quantity.bound = read_value(table, run, quantity, "at_most");
      break;
    case Measure::minimum:
      quantity.bound = read_value(table, run, quantity, "at_least");
      break;
    case Measure::time_when_below:
      quantity.value = read_value(table, run, quantity, "value");
      quantity.expected_time = table.quantity("expected", input::dimension::time, positive);
      quantity.tolerance = relative_tolerance();
      break;
  }
}

ExpectedQuantity read_quantity(TableReader& table, const Run& run) {
  ExpectedQuantity quantity;
  read_name(table, run, quantity);
  read_unit(table, run, quantity);
  quantity.reason = table.text("reason");
  const std::optional<Measure> measure = table.choice("measure", measures);
  if (!measure) return quantity;
  quantity.measure = *measure;
  read_measure(table, run, quantity);
  table.refuse_unknown_keys();
  return quantity;
}

}  // namespace

std::string_view name(Measure measure) {
  for (const Named<Measure>& entry : measures)
    if (entry.value == measure) return entry.name;
  return {};
}

Expectations read_expectations(const std::filesystem::path& file, double end_time,
                               std::span<const HistoryColumn> columns) {
  FaultList faults;
  const input::SourceValue source = input::read_toml(file, faults);
  if (!faults.empty()) throw CaseFaults(faults);
  const Run run{file.has_parent_path() ? file.parent_path() : ".", end_time, columns};
  TableReader document(source, "", faults);
  Expectations expectations;
  for (TableReader& table : document.tables("quantity"))
    expectations.quantities.push_back(read_quantity(table, run));
  document.refuse_unknown_keys();
  if (!faults.empty()) throw CaseFaults(faults);
  return expectations;
}

}  // namespace fissura
