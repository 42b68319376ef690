// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/column_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

template <class Value, class Of>
std::vector<Value> each(const std::vector<SeismicEvent>& events, const Of& of) {
  std::vector<Value> values;
  values.reserve(events.size());
  for (SeismicEvent event : events) values.push_back(of(event));
  return values;
}

double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

double finite(double value) {
  if (!std::isfinite(value)) throw InputError(fmt::format("holds {}", value));
  return value;
}

std::uint8_t known(const WordColumn& column, std::uint8_t number) {
  const bool found = std::any_of(column.words.begin(), column.words.end(),
                                 [number](const auto& word) { return word.first == number; });
  if (!found) throw InputError(fmt::format("holds the number {}, that of no word", number));
  return number;
}

template <class Value, class Take>
void take_each(const ColumnValues& values, std::vector<SeismicEvent>& events, const Take& take) {
  const auto* list = std::get_if<std::vector<Value>>(&values);
  if (list == nullptr) throw InputError("is of another type");
  if (list->size() != events.size())
    throw InputError(fmt::format("has {} values for {} events", list->size(), events.size()));
  for (std::size_t i = 0; i < events.size(); ++i) take(events[i], (*list)[i]);
}

}  // namespace

ColumnValues column_values(const EventColumn& column, const std::vector<SeismicEvent>& events,
                           const CatalogueContext& context) {
  return std::visit(
      ColumnCases{[&](const NumberColumn& c) -> ColumnValues { return each<double>(events, c.value); },
                  [&](const AngleColumn& c) -> ColumnValues { return each<double>(events, c.value); },
                  [&](const OptionalColumn& c) -> ColumnValues {
                    return each<double>(events, [&](SeismicEvent& e) { return or_nan(c.value(e)); });
                  },
                  [&](const DerivedColumn& c) -> ColumnValues {
                    return each<double>(events,
                                        [&](const SeismicEvent& e) { return or_nan(c.value(e, context)); });
                  },
                  [&](const CountColumn& c) -> ColumnValues { return each<std::uint64_t>(events, c.value); },
                  [&](const WordColumn& c) -> ColumnValues { return each<std::uint8_t>(events, c.number); },
                  [](const DerivedTextColumn&) -> ColumnValues { return std::monostate(); }},
      column.content);
}

std::string listed_words(const EventColumn& column) {
  const auto* words = std::get_if<WordColumn>(&column.content);
  if (words == nullptr) return {};
  std::string text;
  for (const auto& [number, word] : words->words)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, word);
  return text;
}

void take_values(const EventColumn& column, const ColumnValues& values, std::vector<SeismicEvent>& events) {
  using Event = SeismicEvent;
  const auto take_numbers = [&](const auto& c) {
    take_each<double>(values, events, [&](Event& e, double value) { c.value(e) = finite(value); });
  };
  try {
    std::visit(ColumnCases{[&](const NumberColumn& c) { take_numbers(c); },
                           [&](const AngleColumn& c) { take_numbers(c); },
                           [&](const OptionalColumn& c) {
                             take_each<double>(values, events, [&](Event& e, double value) {
                               c.value(e) = std::isnan(value) ? std::nullopt : std::optional(finite(value));
                             });
                           },
                           [&](const CountColumn& c) { take_each<std::uint64_t>(values, events, c.set); },
                           [&](const WordColumn& c) {
                             take_each<std::uint8_t>(values, events, [&](Event& e, std::uint8_t number) {
                               c.set(e, known(c, number));
                             });
                           },
                           [](const DerivedColumn&) {}, [](const DerivedTextColumn&) {}},
               column.content);
  } catch (const InputError& fault) {
    throw InputError(fmt::format("the column {} {}", column.name, fault.what()));
  }
}

}  // namespace fissura::coupler
