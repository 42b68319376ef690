// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/case/names.hpp"
#include "common/case/range.hpp"
#include "common/case/source_value.hpp"
#include "common/case/units.hpp"

namespace fissura::input {

/// Reads one table of a case key by key and collects what is wrong with it; nothing here throws for a faulty
/// case.
///
/// A value that is missing or wrong is reported once and reads as not-a-number (or empty text), so that a
/// later check comparing it stays silent. The functions with a `fallback` take a missing key as that value;
/// those without report it. Every key asked for is a known key: see refuse_unknown_keys.
class TableReader {
 public:
  /// `path` is the key path of the table (empty for the whole document). @pre `table` holds a SourceTable
  TableReader(const SourceValue& table, std::string path, FaultList& faults);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string path_of(std::string_view key) const;

  /// Whether the key is there.
  bool has(std::string_view key);

  /// Text with a unit, such as "32 GPa"; the value in SI.
  double quantity(std::string_view key, const Dimension& dimension, const Range& range);
  double quantity(std::string_view key, const Dimension& dimension, const Range& range, double fallback);

  /// Array of two such texts.
  std::array<double, 2> vector(std::string_view key, const Dimension& dimension);
  std::array<double, 2> vector(std::string_view key, const Dimension& dimension,
                               const std::array<double, 2>& fallback);

  /// Array of at least two arrays of two lengths [m].
  std::vector<std::array<double, 2>> points(std::string_view key);

  /// Bare number (an integer will do).
  double number(std::string_view key, const Range& range);
  double number(std::string_view key, const Range& range, double fallback);

  /// Bare whole number; a faulty one reads as the fallback.
  int count(std::string_view key, const Range& range, int fallback);
  std::uint64_t natural_number(std::string_view key, std::uint64_t fallback);
  /// Bare whole number, which must be there; a faulty one reads as 0.
  std::int64_t whole_number(std::string_view key, const Range& range);

  /// Bare whole number, or the word "every", which reads as nothing; a missing or faulty one as the fallback.
  std::optional<std::uint64_t> natural_number_or_every(std::string_view key,
                                                       std::optional<std::uint64_t> fallback);
  /// Bare number; `nan` and `inf` are numbers here.
  double any_number(std::string_view key);

  bool flag(std::string_view key, bool fallback);

  /// Text, not empty.
  std::string text(std::string_view key);
  std::string text(std::string_view key, const std::string& fallback);

  /// One of some words; a faulty one reads as empty.
  std::string word(std::string_view key, const std::vector<std::string>& allowed);

  /// One of the names of an enumeration; a missing or faulty one reads as nothing.
  template <class E, std::size_t N>
  std::optional<E> choice(std::string_view key, const std::array<Named<E>, N>& names) {
    const std::string chosen = word(key, texts_of(names));
    for (const Named<E>& entry : names)
      if (entry.name == chosen) return entry.value;
    return {};
  }
  template <class E, std::size_t N>
  E choice(std::string_view key, const std::array<Named<E>, N>& names, E fallback) {
    return has(key) ? choice(key, names).value_or(fallback) : fallback;
  }

  /// The table under the key; if it is missing, that is a fault, and nothing more is reported about its keys.
  TableReader table(std::string_view key);
  /// The table under the key, or an empty one.
  TableReader optional_table(std::string_view key);
  /// The tables of an array of tables, which must have at least one.
  std::vector<TableReader> tables(std::string_view key);
  /// The same, or none at all if the key is missing.
  std::vector<TableReader> optional_tables(std::string_view key);

  /// Reports the value under the key as wrong (as missing, if it is). `expected` stands behind "expected".
  void refuse(std::string_view key, const std::string& expected);
  void refuse(std::string_view key, const std::string& found, const std::string& expected);

  /// Reports every key that nobody has asked for, with the most similar of those that somebody has.
  void refuse_unknown_keys();

 private:
  enum class Missing { reported, ignored };
  TableReader(const SourceValue& table, std::string path, FaultList& faults, Missing missing);

  const SourceValue* find(std::string_view key);
  const SourceValue* require(std::string_view key, const std::string& expected);
  void report(const SourceValue& value, const std::string& path, const std::string& expected,
              const std::string& suggestion);
  double read_quantity(const SourceValue& value, const std::string& path, const Dimension& dimension,
                       const Range& range);
  std::array<double, 2> read_vector(const SourceValue& value, const std::string& path,
                                    const Dimension& dimension);
  double read_number(const SourceValue& value, const std::string& path, const Range& range);
  std::string read_text(const SourceValue& value, const std::string& path);

  const SourceValue* table_;
  std::string path_;
  FaultList* faults_;
  Missing missing_;
  std::vector<std::string> known_keys_;
};

}  // namespace fissura::input
