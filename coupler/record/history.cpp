// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/history.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "coupler/record/number_table.hpp"
#include "coupler/record/recorded_scalars.hpp"

namespace fissura::coupler {

namespace {

constexpr const char *history_name = "history.csv", *ledger_name = "ledger.csv";
constexpr std::array<std::string_view, 10> ledger_columns{
    "interval",     "time",   "injected", "in_place", "found",
    "in_fractures", "leaked", "reset",    "residual", "relative_residual"};

double value_of(const IntervalRecord& record, std::string_view column) {
  return recorded_scalars()[recorded_scalar_index(column).value()].value(record);
}

void append_value(std::string& line, double value) {
  if (!line.empty()) line += ',';
  line += fmt::format("{}", value);
}

void append_name(std::string& line, std::string_view name) {
  if (!line.empty()) line += ',';
  line += name;
}

}  // namespace

std::string columns_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const RecordedScalar& column : recorded_scalars())
    list.push_back({{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
  return list.dump(2) + "\n";
}

History::History() : values_(recorded_scalars().size()) {
  observe({});
}

void History::observe(const std::vector<std::string>& probes) {
  probes_.emplace(probes);
}

void History::write_to(const std::filesystem::path& directory) {
  write_whole_file(directory / "columns.json", columns_json());
  tables_.emplace(Tables{CheckedFile(directory / history_name), CheckedFile(directory / ledger_name)});
  std::string history_header, ledger_header;
  for (const RecordedScalar& column : recorded_scalars()) append_name(history_header, column.name);
  for (const std::string_view column : ledger_columns) append_name(ledger_header, column);
  tables_->history.append(history_header + '\n');
  tables_->ledger.append(ledger_header + '\n');
  probes_->write_to(directory);
  flush();
}

void History::add(const IntervalRecord& record, const std::vector<ProbeValues>& probes) {
  probes_->add(record.time, probes);
  std::string history_line, ledger_line;
  for (std::size_t column = 0; column < values_.size(); ++column) {
    const double value = recorded_scalars()[column].value(record);
    values_[column].push_back(value);
    append_value(history_line, value);
  }
  for (const std::string_view column : ledger_columns) append_value(ledger_line, value_of(record, column));
  last_ = record;
  if (!tables_) return;
  tables_->history.append(history_line + '\n');
  tables_->ledger.append(ledger_line + '\n');
}

void History::flush() {
  probes_->flush();
  if (!tables_) return;
  tables_->history.flush();
  tables_->ledger.flush();
}

void History::save(TableMarks& marks, ByteWriter& archive) {
  ENSURE(tables_.has_value());
  tables_->history.sync();
  tables_->ledger.sync();
  marks[history_name] = tables_->history.mark();
  marks[ledger_name] = tables_->ledger.mark();
  probes_->save(marks);
  archive.put(last_);
}

void History::resume(const std::filesystem::path& directory, const TableMarks& marks, ByteReader& archive) {
  std::optional<CheckedFile> history = at_mark(directory, history_name, marks),
                             ledger = at_mark(directory, ledger_name, marks);
  if (!history || !ledger)
    throw Error(ExitCode::checkpoint_unusable, "the checkpoint knows nothing of history.csv and ledger.csv");
  tables_.emplace(Tables{std::move(*history), std::move(*ledger)});
  write_whole_file(directory / "columns.json", columns_json());
  values_ = read_number_table(directory / history_name, values_.size());
  probes_->resume(directory, marks);
  archive.get(last_);
}

std::optional<std::span<const double>> History::series(std::string_view name) const {
  const auto column = recorded_scalar_index(name);
  if (!column) return probes_->series(name);
  return values_[*column];
}

const IntervalRecord& History::last() const {
  ENSURE(size() > 0);
  return last_;
}

}  // namespace fissura::coupler
