// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/probes.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "common/errors.hpp"
#include "coupler/record/csv_cell.hpp"
#include "coupler/record/number_table.hpp"

namespace fissura::coupler {

namespace {

using Value = std::optional<double>;

constexpr const char* table_name = "probes.csv";

constexpr std::array quantities{
    ProbeQuantity{"stress_xx", "Pa", [](const ProbeValues& p) -> Value { return p.stress_xx; }},
    ProbeQuantity{"stress_yy", "Pa", [](const ProbeValues& p) -> Value { return p.stress_yy; }},
    ProbeQuantity{"stress_xy", "Pa", [](const ProbeValues& p) -> Value { return p.stress_xy; }},
    ProbeQuantity{"displacement_x", "m", [](const ProbeValues& p) -> Value { return p.displacement_x; }},
    ProbeQuantity{"displacement_y", "m", [](const ProbeValues& p) -> Value { return p.displacement_y; }},
    ProbeQuantity{"slip", "m", [](const ProbeValues& p) { return p.slip; }},
    ProbeQuantity{"opening", "m", [](const ProbeValues& p) { return p.opening; }},
    ProbeQuantity{"normal_traction", "Pa", [](const ProbeValues& p) { return p.normal_traction; }},
    ProbeQuantity{"shear_traction", "Pa", [](const ProbeValues& p) { return p.shear_traction; }},
};

double required(const nlohmann::json& object, const char* key) {
  return object.at(key).get<double>();
}

Value number_or_null(const nlohmann::json& object, const char* key) {
  return object.at(key).is_null() ? Value() : required(object, key);
}

}  // namespace

ProbeValues probe_values_from_json(const nlohmann::json& object) {
  try {
    ProbeValues values;
    values.stress_xx = required(object, "stress_xx");
    values.stress_yy = required(object, "stress_yy");
    values.stress_xy = required(object, "stress_xy");
    values.displacement_x = required(object, "displacement_x");
    values.displacement_y = required(object, "displacement_y");
    values.slip = number_or_null(object, "slip");
    values.opening = number_or_null(object, "opening");
    values.normal_traction = number_or_null(object, "normal_traction");
    values.shear_traction = number_or_null(object, "shear_traction");
    return values;
  } catch (const nlohmann::json::exception& error) {
    throw ProtocolError(fmt::format("an entry of probes is not complete: {}", error.what()));
  }
}

std::span<const ProbeQuantity> probe_quantities() {
  return quantities;
}

std::vector<ProbeColumn> probe_columns(const std::vector<std::string>& names) {
  std::vector<ProbeColumn> columns;
  for (const std::string& name : names)
    for (const ProbeQuantity& quantity : quantities)
      for (const char* ending : {"", "_change"})
        columns.push_back({fmt::format("probe.{}.{}{}", name, quantity.name, ending), quantity.unit});
  return columns;
}

ProbeSeries::ProbeSeries(const std::vector<std::string>& names) : names_(names) {
  for (const ProbeColumn& column : probe_columns(names)) columns_.emplace(column.name, columns_.size());
  values_.resize(columns_.size());
}

void ProbeSeries::write_to(const std::filesystem::path& directory) {
  if (names_.empty()) return;
  std::string header = "time";
  for (const std::string& name : names_)
    for (const ProbeQuantity& quantity : quantities)
      header += ',' + csv_cell(fmt::format("{}.{}", name, quantity.name));
  table_.emplace(directory / table_name);
  table_->append(header + '\n');
}

void ProbeSeries::add(double time, const std::vector<ProbeValues>& probes) {
  if (!probes.empty() && probes.size() != names_.size())
    throw ProtocolError(
        fmt::format("the structure told of {} probes, the case has {}", probes.size(), names_.size()));
  std::string line = fmt::format("{}", time);
  std::size_t column = 0;
  for (std::size_t probe = 0; probe < names_.size(); ++probe)
    for (const ProbeQuantity& quantity : quantities) {
      const double untold = std::numeric_limits<double>::quiet_NaN();
      const double value = probes.empty() ? untold : quantity.value(probes[probe]).value_or(untold);
      line += fmt::format(",{}", value);
      keep(column++, value);
    }
  if (table_) table_->append(line + '\n');
}

void ProbeSeries::keep(std::size_t quantity, double value) {
  std::vector<double>& values = values_[2 * quantity];
  values.push_back(value);
  values_[2 * quantity + 1].push_back(value - values.front());
}

void ProbeSeries::save(TableMarks& marks) {
  if (!table_) return;
  table_->sync();
  marks[table_name] = table_->mark();
}

void ProbeSeries::resume(const std::filesystem::path& directory, const TableMarks& marks) {
  if (names_.empty()) return;
  table_ = at_mark(directory, table_name, marks);
  if (!table_) throw Error(ExitCode::checkpoint_unusable, "the checkpoint knows nothing of probes.csv");
  const std::size_t columns = names_.size() * quantities.size();
  const std::vector<std::vector<double>> table = read_number_table(directory / table_name, 1 + columns);
  for (std::size_t column = 0; column < columns; ++column)
    for (const double value : table[1 + column]) keep(column, value);
}

void ProbeSeries::flush() {
  if (table_) table_->flush();
}

std::optional<std::span<const double>> ProbeSeries::series(std::string_view name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end()) return std::nullopt;
  return values_[found->second];
}

}  // namespace fissura::coupler
