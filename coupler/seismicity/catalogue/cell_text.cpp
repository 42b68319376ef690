// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "coupler/seismicity/catalogue/event_columns.hpp"

namespace fissura::coupler {

namespace {

constexpr long double degree = std::numbers::pi_v<long double> / 180;
constexpr int digits_of_a_double = 15, digits_of_any_number = 21;

template <class Number>
Number parsed(std::string_view text) {
  Number value{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size())
    throw InputError(fmt::format("\"{}\" is not a number", text));
  return value;
}

double finite(std::string_view text) {
  const auto value = parsed<double>(text);
  if (!std::isfinite(value)) throw InputError(fmt::format("\"{}\" is not finite", text));
  return value;
}

double radians_of(std::string_view degrees) {
  const auto value = static_cast<double>(parsed<long double>(degrees) * degree);
  if (!std::isfinite(value)) throw InputError(fmt::format("\"{}\" is not finite", degrees));
  return value;
}

std::string word_of(const WordColumn& column, std::uint8_t number) {
  for (const auto& [of_word, word] : column.words)
    if (of_word == number) return word;
  ENSURE(!"an enumeration holds a value without a name");
  return {};
}

std::uint8_t number_of(const WordColumn& column, std::string_view text) {
  for (const auto& [number, word] : column.words)
    if (word == text) return number;
  throw InputError(fmt::format("\"{}\" is no word of this column", text));
}

}  // namespace

// Degrees as a double would not tell all radians apart, so the product is formed with more digits.
std::string degrees_text(double radians) {
  const long double degrees = radians / degree;
  std::string text;
  for (int digits = digits_of_a_double; digits <= digits_of_any_number; ++digits) {
    text = fmt::format("{:.{}g}", degrees, digits);
    if (radians_of(text) == radians) break;
  }
  return text;
}

std::string cell_text(const EventColumn& column, const SeismicEvent& event, const CatalogueContext& context) {
  // The accessors give references that a reader can write to.
  SeismicEvent readable = event;
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string();
  };
  return std::visit(ColumnCases{[&](const NumberColumn& c) { return fmt::format("{}", c.value(readable)); },
                                [&](const AngleColumn& c) { return degrees_text(c.value(readable)); },
                                [&](const OptionalColumn& c) { return number(c.value(readable)); },
                                [&](const CountColumn& c) { return fmt::format("{}", c.value(event)); },
                                [&](const WordColumn& c) { return word_of(c, c.number(event)); },
                                [&](const DerivedColumn& c) { return number(c.value(event, context)); },
                                [&](const DerivedTextColumn& c) { return c.text(event, context); }},
                    column.content);
}

void take_cell(const EventColumn& column, std::string_view text, SeismicEvent& event) {
  std::visit(ColumnCases{[&](const NumberColumn& c) { c.value(event) = finite(text); },
                         [&](const AngleColumn& c) { c.value(event) = radians_of(text); },
                         [&](const OptionalColumn& c) {
                           c.value(event) = text.empty() ? std::nullopt : std::optional(finite(text));
                         },
                         [&](const CountColumn& c) { c.set(event, parsed<std::uint64_t>(text)); },
                         [&](const WordColumn& c) { c.set(event, number_of(c, text)); },
                         [](const DerivedColumn&) {}, [](const DerivedTextColumn&) {}},
             column.content);
}

}  // namespace fissura::coupler
