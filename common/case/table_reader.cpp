// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fissura::input {

namespace {

constexpr double unreadable = std::numeric_limits<double>::quiet_NaN();

const SourceValue empty_table{{}, SourceTable{}};

std::string expectation(const Dimension& dimension, const Range& range) {
  const bool limited = std::isfinite(range.lower) || std::isfinite(range.upper);
  const std::string limits = limited ? ", " + describe(range, dimension.unit) : "";
  return fmt::format("{} with its unit such as \"{}\"{}", dimension.name, dimension.example, limits);
}

std::string expectation(const Range& range) {
  return "a number " + describe(range, "");
}

}  // namespace

TableReader::TableReader(const SourceValue& table, std::string path, FaultList& faults)
    : TableReader(table, std::move(path), faults, Missing::reported) {}

TableReader::TableReader(const SourceValue& table, std::string path, FaultList& faults, Missing missing)
    : table_(&table), path_(std::move(path)), faults_(&faults), missing_(missing) {}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

const SourceValue* TableReader::find(std::string_view key) {
  if (std::find(known_keys_.begin(), known_keys_.end(), key) == known_keys_.end())
    known_keys_.emplace_back(key);
  const SourceMember* member = member_of(*table_, key);
  return member == nullptr ? nullptr : &member->value;
}

const SourceValue* TableReader::require(std::string_view key, const std::string& expected) {
  const SourceValue* value = find(key);
  if (value == nullptr && missing_ == Missing::reported)
    faults_->push_back({table_->where, path_of(key), "nothing", expected, ""});
  return value;
}

void TableReader::report(const SourceValue& value, const std::string& path, const std::string& expected,
                         const std::string& suggestion) {
  faults_->push_back({value.where, path, written(value), expected, suggestion});
}

bool TableReader::has(std::string_view key) {
  return find(key) != nullptr;
}

double TableReader::read_quantity(const SourceValue& value, const std::string& path,
                                  const Dimension& dimension, const Range& range) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (text == nullptr) {
    report(value, path, expectation(dimension, range), "");
    return unreadable;
  }
  try {
    const double number = in_si(*text, dimension);
    if (range.contains(number)) return number;
    report(value, path, expectation(dimension, range), "");
  } catch (const InputError& error) {
    report(value, path, error.what(), "");
  }
  return unreadable;
}

double TableReader::quantity(std::string_view key, const Dimension& dimension, const Range& range) {
  const SourceValue* value = require(key, expectation(dimension, range));
  return value == nullptr ? unreadable : read_quantity(*value, path_of(key), dimension, range);
}

double TableReader::quantity(std::string_view key, const Dimension& dimension, const Range& range,
                             double fallback) {
  return has(key) ? quantity(key, dimension, range) : fallback;
}

std::array<double, 2> TableReader::read_vector(const SourceValue& value, const std::string& path,
                                               const Dimension& dimension) {
  const auto* array = std::get_if<SourceArray>(&value.content);
  if (array == nullptr || array->elements.size() != 2) {
    report(value, path, fmt::format("two components such as [\"{0}\", \"{0}\"]", dimension.example), "");
    return {unreadable, unreadable};
  }
  return {read_quantity(array->elements[0], path + "[0]", dimension, any_value),
          read_quantity(array->elements[1], path + "[1]", dimension, any_value)};
}

std::array<double, 2> TableReader::vector(std::string_view key, const Dimension& dimension) {
  const SourceValue* value =
      require(key, fmt::format("two components such as [\"{0}\", \"{0}\"]", dimension.example));
  if (value == nullptr) return {unreadable, unreadable};
  return read_vector(*value, path_of(key), dimension);
}

std::array<double, 2> TableReader::vector(std::string_view key, const Dimension& dimension,
                                          const std::array<double, 2>& fallback) {
  return has(key) ? vector(key, dimension) : fallback;
}

std::vector<std::array<double, 2>> TableReader::points(std::string_view key) {
  const std::string expected = R"(at least two points such as [["-1 m", "0 m"], ["1 m", "0 m"]])";
  const SourceValue* value = require(key, expected);
  if (value == nullptr) return {};
  const auto* array = std::get_if<SourceArray>(&value->content);
  if (array == nullptr || array->elements.size() < 2) {
    report(*value, path_of(key), expected, "");
    return {};
  }
  std::vector<std::array<double, 2>> result;
  for (const SourceValue& element : array->elements)
    result.push_back(
        read_vector(element, fmt::format("{}[{}]", path_of(key), result.size()), dimension::length));
  return result;
}

double TableReader::read_number(const SourceValue& value, const std::string& path, const Range& range) {
  double number = unreadable;
  if (const auto* real = std::get_if<double>(&value.content)) number = *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value.content)) number = static_cast<double>(*integer);
  if (std::isfinite(number) && range.contains(number)) return number;
  report(value, path, expectation(range), "");
  return unreadable;
}

double TableReader::number(std::string_view key, const Range& range) {
  const SourceValue* value = require(key, expectation(range));
  return value == nullptr ? unreadable : read_number(*value, path_of(key), range);
}

double TableReader::number(std::string_view key, const Range& range, double fallback) {
  return has(key) ? number(key, range) : fallback;
}

int TableReader::count(std::string_view key, const Range& range, int fallback) {
  const SourceValue* value = find(key);
  if (value == nullptr) return fallback;
  constexpr double largest = std::numeric_limits<int>::max();
  const auto* whole = std::get_if<std::int64_t>(&value->content);
  if (whole != nullptr && range.contains(static_cast<double>(*whole)) &&
      static_cast<double>(*whole) <= largest)
    return static_cast<int>(*whole);
  report(*value, path_of(key), "a whole number " + describe(range, ""), "");
  return fallback;
}

std::uint64_t TableReader::natural_number(std::string_view key, std::uint64_t fallback) {
  const SourceValue* value = find(key);
  if (value == nullptr) return fallback;
  const auto* whole = std::get_if<std::int64_t>(&value->content);
  if (whole != nullptr && *whole >= 0) return static_cast<std::uint64_t>(*whole);
  report(*value, path_of(key), "a whole number at least 0", "");
  return fallback;
}

std::int64_t TableReader::whole_number(std::string_view key, const Range& range) {
  const std::string allowed = "a whole number " + describe(range, "");
  const SourceValue* value = require(key, allowed);
  if (value == nullptr) return 0;
  const auto* whole = std::get_if<std::int64_t>(&value->content);
  if (whole != nullptr && range.contains(static_cast<double>(*whole))) return *whole;
  report(*value, path_of(key), allowed, "");
  return 0;
}

std::optional<std::uint64_t> TableReader::natural_number_or_every(std::string_view key,
                                                                  std::optional<std::uint64_t> fallback) {
  const SourceValue* value = find(key);
  if (value == nullptr) return fallback;
  const auto* whole = std::get_if<std::int64_t>(&value->content);
  if (whole != nullptr && *whole >= 0) return static_cast<std::uint64_t>(*whole);
  const auto* text = std::get_if<std::string>(&value->content);
  if (text != nullptr && *text == "every") return std::nullopt;
  report(*value, path_of(key), "a whole number at least 0, or \"every\"", "");
  return fallback;
}

double TableReader::any_number(std::string_view key) {
  const SourceValue* value = require(key, "a number");
  if (value == nullptr) return unreadable;
  if (const auto* real = std::get_if<double>(&value->content)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value->content)) return static_cast<double>(*integer);
  report(*value, path_of(key), "a number", "");
  return unreadable;
}

bool TableReader::flag(std::string_view key, bool fallback) {
  const SourceValue* value = find(key);
  if (value == nullptr) return fallback;
  if (const auto* flag = std::get_if<bool>(&value->content)) return *flag;
  report(*value, path_of(key), "true or false", "");
  return fallback;
}

std::string TableReader::read_text(const SourceValue& value, const std::string& path) {
  const auto* text = std::get_if<std::string>(&value.content);
  if (text != nullptr && !text->empty()) return *text;
  report(value, path, "a text that is not empty", "");
  return {};
}

std::string TableReader::text(std::string_view key) {
  const SourceValue* value = require(key, "a text");
  return value == nullptr ? std::string() : read_text(*value, path_of(key));
}

std::string TableReader::text(std::string_view key, const std::string& fallback) {
  return has(key) ? text(key) : fallback;
}

std::string TableReader::word(std::string_view key, const std::vector<std::string>& allowed) {
  const std::string expected = "one of " + listed(allowed);
  const SourceValue* value = require(key, expected);
  if (value == nullptr) return {};
  const auto* text = std::get_if<std::string>(&value->content);
  if (text != nullptr && std::find(allowed.begin(), allowed.end(), *text) != allowed.end()) return *text;
  report(*value, path_of(key), expected, text == nullptr ? "" : closest_word(*text, allowed));
  return {};
}

TableReader TableReader::table(std::string_view key) {
  const SourceValue* value = require(key, fmt::format("a table [{}]", path_of(key)));
  if (value != nullptr && std::holds_alternative<SourceTable>(value->content))
    return {*value, path_of(key), *faults_, missing_};
  if (value != nullptr) report(*value, path_of(key), fmt::format("a table [{}]", path_of(key)), "");
  return {empty_table, path_of(key), *faults_, Missing::ignored};
}

TableReader TableReader::optional_table(std::string_view key) {
  return has(key) ? table(key) : TableReader(empty_table, path_of(key), *faults_, Missing::ignored);
}

std::vector<TableReader> TableReader::tables(std::string_view key) {
  const std::string expected = fmt::format("at least one table [[{}]]", path_of(key));
  std::vector<TableReader> result;
  const SourceValue* value = require(key, expected);
  if (value == nullptr) return result;
  const auto* array = std::get_if<SourceArray>(&value->content);
  if (array == nullptr || array->elements.empty()) {
    report(*value, path_of(key), expected, "");
    return result;
  }
  for (const SourceValue& element : array->elements) {
    const std::string path = fmt::format("{}[{}]", path_of(key), result.size());
    const bool is_table = std::holds_alternative<SourceTable>(element.content);
    if (!is_table) report(element, path, "a table", "");
    result.push_back(is_table ? TableReader(element, path, *faults_)
                              : TableReader(empty_table, path, *faults_, Missing::ignored));
  }
  return result;
}

std::vector<TableReader> TableReader::optional_tables(std::string_view key) {
  return has(key) ? tables(key) : std::vector<TableReader>();
}

void TableReader::refuse(std::string_view key, const std::string& expected) {
  const SourceMember* member = member_of(*table_, key);
  if (member != nullptr) {
    report(member->value, path_of(key), expected, "");
  } else if (missing_ == Missing::reported) {
    faults_->push_back({table_->where, path_of(key), "nothing", expected, ""});
  }
}

void TableReader::refuse(std::string_view key, const std::string& found, const std::string& expected) {
  const SourceMember* member = member_of(*table_, key);
  const SourcePosition where = member == nullptr ? table_->where : member->value.where;
  faults_->push_back({where, path_of(key), found, expected, ""});
}

void TableReader::refuse_unknown_keys() {
  for (const SourceMember& member : std::get<SourceTable>(table_->content).members) {
    if (std::find(known_keys_.begin(), known_keys_.end(), member.key) != known_keys_.end()) continue;
    faults_->push_back({member.where, path_of(member.key), "an unknown key", "one of " + listed(known_keys_),
                        closest_word(member.key, known_keys_)});
  }
}

}  // namespace fissura::input
