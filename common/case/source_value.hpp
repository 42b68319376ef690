// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/case/faults.hpp"

/// A TOML document as a tree in which every value knows where it was written.
namespace fissura::input {

struct SourceValue;
struct SourceMember;

struct SourceArray {
  std::vector<SourceValue> elements;
};

struct SourceTable {
  std::vector<SourceMember> members;  ///< no two with the same key
};

/// A date or a time: no key of a case takes one.
struct SourceDate {};

struct SourceValue {
  SourcePosition where;
  std::variant<SourceTable, SourceArray, std::string, std::int64_t, double, bool, SourceDate> content;
};

struct SourceMember {
  std::string key;
  SourcePosition where;  ///< of the key
  SourceValue value;
};

/// As written, for a sentence: `"32 GPa"`, `0.2`, `an array`.
std::string written(const SourceValue& value);

/// The member of a table; null if `value` is not a table or has no such key.
const SourceMember* member_of(const SourceValue& value, std::string_view key);

/// One step of a key path: a key, or a place in an array.
using PathStep = std::variant<std::string, std::size_t>;

/// Steps of "injection.stage[1].rate". Throws InputError if the path is empty or malformed.
std::vector<PathStep> parse_path(std::string_view path);

/// Where the value at `path` was written, or else the nearest table or array around it.
SourcePosition position_of(const SourceValue& document, std::string_view path);

/// Puts `changes` over `base`: tables merge key by key, everything else is replaced.
void merge(SourceValue& base, const SourceValue& changes);

/// Puts `value` at `path`, making tables on the way where there are none. Throws InputError if the path is
/// malformed, or leads beyond the end of an array or through a value that is neither table nor array.
void put(SourceValue& document, std::string_view path, SourceValue value);

}  // namespace fissura::input
