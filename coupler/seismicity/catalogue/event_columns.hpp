// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coupler/seismicity/catalogue/catalogue_context.hpp"
#include "coupler/seismicity/seismic_event.hpp"

/// The catalogue as a table, one row an event: what the CSV file, the HDF5 file and QuakeML's own elements
/// have in common.
namespace fissura::coupler {

/// A number of the event itself.
struct NumberColumn {
  double& (*value)(SeismicEvent&);
};

/// An angle of the event [rad]; in text it stands in degrees.
struct AngleColumn {
  double& (*value)(SeismicEvent&);
};

/// A number that an event may lack.
struct OptionalColumn {
  std::optional<double>& (*value)(SeismicEvent&);
};

struct CountColumn {
  std::uint64_t (*value)(const SeismicEvent&);
  void (*set)(SeismicEvent&, std::uint64_t);
};

/// One of a few words, each with a number for binary files.
struct WordColumn {
  std::uint8_t (*number)(const SeismicEvent&);
  void (*set)(SeismicEvent&, std::uint8_t);
  std::vector<std::pair<std::uint8_t, std::string>> words;
};

/// Follows from the rest; a reader passes over it.
struct DerivedColumn {
  std::optional<double> (*value)(const SeismicEvent&, const CatalogueContext&);
};
struct DerivedTextColumn {
  std::string (*text)(const SeismicEvent&, const CatalogueContext&);
};

struct EventColumn {
  std::string_view name;         ///< in binary files
  std::string_view unit_suffix;  ///< name + unit_suffix is the name in text
  std::string_view unit;         ///< SI; of the values in binary files
  std::string_view meaning;
  std::variant<NumberColumn, AngleColumn, OptionalColumn, CountColumn, WordColumn, DerivedColumn,
               DerivedTextColumn>
      content;

  [[nodiscard]] std::string text_name() const { return std::string(name) + std::string(unit_suffix); }
};

/// All columns in their order. Those that are not derived restore every member of SeismicEvent.
const std::vector<EventColumn>& event_columns();

/// A function for each kind of column, for std::visit.
template <class... Cases>
struct ColumnCases : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
ColumnCases(Cases...) -> ColumnCases<Cases...>;

/// Whether the column says nothing beyond what the others and the context say.
bool is_derived(const EventColumn& column);

/// The cell of a column: numbers with the fewest digits that read back to the same bits, empty where there is
/// nothing.
std::string cell_text(const EventColumn& column, const SeismicEvent& event, const CatalogueContext& context);

/// Takes such a cell back into `event`; nothing for a derived column. Throws InputError, its sentence without
/// file and line, if the text is no value of the column.
void take_cell(const EventColumn& column, std::string_view text, SeismicEvent& event);

/// An angle [rad] in degrees, with the fewest digits (from fifteen on) that read back to the same bits.
std::string degrees_text(double radians);

}  // namespace fissura::coupler
