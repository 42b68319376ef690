// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "coupler/seismicity/catalogue/event_columns.hpp"

namespace fissura::coupler {

/// The values of a column in SI: numbers and angles [rad], counts, numbers of words; nothing of a text that
/// follows from the rest.
using ColumnValues =
    std::variant<std::monostate, std::vector<double>, std::vector<std::uint64_t>, std::vector<std::uint8_t>>;

/// One value an event, in their order; NaN where an event has none.
ColumnValues column_values(const EventColumn& column, const std::vector<SeismicEvent>& events,
                           const CatalogueContext& context);

/// The values that tell the column's words apart, "1 shear, 2 tensile, ..."; empty for any other column.
std::string listed_words(const EventColumn& column);

/// Takes such values back, each into the event of its place; nothing for a derived column. Throws InputError
/// with the name of the column if there are more or fewer of them than events, they are of another type, or
/// one of them is no value of the column.
void take_values(const EventColumn& column, const ColumnValues& values, std::vector<SeismicEvent>& events);

}  // namespace fissura::coupler
