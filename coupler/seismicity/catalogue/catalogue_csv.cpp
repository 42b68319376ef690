// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "common/errors.hpp"
#include "coupler/seismicity/catalogue/event_columns.hpp"

namespace fissura::coupler {

namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(line.substr(begin, comma - begin));
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

/// The column of each cell of a line; none for cells that say nothing of the event itself.
std::vector<const EventColumn*> columns_of(std::string_view header, const std::filesystem::path& file) {
  const std::vector<std::string_view> names = cells_of(header);
  std::vector<const EventColumn*> columns(names.size(), nullptr);
  for (const EventColumn& column : event_columns()) {
    if (is_derived(column)) continue;
    const auto found = std::find(names.begin(), names.end(), column.text_name());
    if (found == names.end())
      throw InputError(fmt::format("{} has no column {}", file.string(), column.text_name()));
    columns[static_cast<std::size_t>(found - names.begin())] = &column;
  }
  return columns;
}

SeismicEvent event_of(std::string_view line, const std::vector<const EventColumn*>& columns) {
  const std::vector<std::string_view> cells = cells_of(line);
  if (cells.size() != columns.size())
    throw InputError(fmt::format("{} cells where {} are expected", cells.size(), columns.size()));
  SeismicEvent event;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (columns[i] != nullptr) take_cell(*columns[i], cells[i], event);
  return event;
}

}  // namespace

std::string csv_header() {
  std::string header;
  for (const EventColumn& column : event_columns()) header += column.text_name() + ',';
  header.back() = '\n';
  return header;
}

std::string csv_line(const SeismicEvent& event, const CatalogueContext& context) {
  std::string line;
  for (const EventColumn& column : event_columns()) line += cell_text(column, event, context) + ',';
  line.back() = '\n';
  return line;
}

CatalogueCsv::CatalogueCsv(const std::filesystem::path& file) : file_(file) {
  file_.append(csv_header());
  file_.flush();
}

void CatalogueCsv::append(const std::vector<SeismicEvent>& events, const CatalogueContext& context) {
  for (const SeismicEvent& event : events) file_.append(csv_line(event, context));
}

std::vector<SeismicEvent> read_catalogue_csv(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream || !content) throw InputError(fmt::format("cannot read {}", file.string()));
  const std::string text = content.str();

  std::vector<SeismicEvent> events;
  std::vector<const EventColumn*> columns;
  std::size_t number = 1;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    try {
      if (number == 1)
        columns = columns_of(line, file);
      else
        events.push_back(event_of(line, columns));
    } catch (const InputError& fault) {
      throw InputError(fmt::format("{}, line {}: {}", file.string(), number, fault.what()));
    }
    ++number;
  }
  if (columns.empty()) throw InputError(fmt::format("{} has no header", file.string()));
  return events;
}

}  // namespace fissura::coupler
