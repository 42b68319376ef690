// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/source_value.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace fissura::input {

namespace {

SourceMember* find(SourceTable& table, std::string_view key) {
  const auto member = std::find_if(table.members.begin(), table.members.end(),
                                   [&](const SourceMember& candidate) { return candidate.key == key; });
  return member == table.members.end() ? nullptr : &*member;
}

InputError malformed(std::string_view path) {
  return InputError(fmt::format("a key path such as injection.stage[0].rate instead of \"{}\"", path));
}

std::string shortened(const std::string& text) {
  constexpr std::size_t longest_shown = 80;
  return text.size() <= longest_shown ? text : text.substr(0, longest_shown) + "...";
}

/// The value one step below, made if it is a missing key of a table.
SourceValue& descend(SourceValue& value, const PathStep& step, const SourcePosition& where) {
  if (const auto* index = std::get_if<std::size_t>(&step)) {
    auto* array = std::get_if<SourceArray>(&value.content);
    if (array == nullptr || *index >= array->elements.size())
      throw InputError(fmt::format("an array with an element [{}] there (counted from 0)", *index));
    return array->elements[*index];
  }
  const std::string& key = std::get<std::string>(step);
  auto* table = std::get_if<SourceTable>(&value.content);
  if (table == nullptr) throw InputError(fmt::format("a table around \"{}\"", key));
  if (SourceMember* member = find(*table, key)) return member->value;
  table->members.push_back({key, where, {where, SourceTable{}}});
  return table->members.back().value;
}

}  // namespace

std::string written(const SourceValue& value) {
  struct Writer {
    std::string operator()(const SourceTable&) const { return "a table"; }
    std::string operator()(const SourceArray&) const { return "an array"; }
    std::string operator()(const std::string& text) const { return fmt::format("\"{}\"", shortened(text)); }
    std::string operator()(std::int64_t number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return fmt::format("{}", number); }
    std::string operator()(bool flag) const { return fmt::format("{}", flag); }
    std::string operator()(SourceDate) const { return "a date or time"; }
  };
  return std::visit(Writer{}, value.content);
}

const SourceMember* member_of(const SourceValue& value, std::string_view key) {
  const auto* table = std::get_if<SourceTable>(&value.content);
  if (table == nullptr) return nullptr;
  const auto member = std::find_if(table->members.begin(), table->members.end(),
                                   [&](const SourceMember& candidate) { return candidate.key == key; });
  return member == table->members.end() ? nullptr : &*member;
}

std::vector<PathStep> parse_path(std::string_view path) {
  std::vector<PathStep> steps;
  std::size_t place = 0;
  while (place < path.size()) {
    if (path[place] == '[') {
      const std::size_t close = path.find(']', place);
      if (steps.empty() || close == std::string_view::npos) throw malformed(path);
      std::size_t index = 0;
      const auto [end, status] = std::from_chars(path.data() + place + 1, path.data() + close, index);
      if (status != std::errc{} || end != path.data() + close) throw malformed(path);
      steps.emplace_back(index);
      place = close + 1;
      continue;
    }
    if (!steps.empty() && path[place++] != '.') throw malformed(path);
    const std::size_t end = std::min(path.find_first_of(".[]", place), path.size());
    if (end == place) throw malformed(path);
    steps.emplace_back(std::string(path.substr(place, end - place)));
    place = end;
  }
  if (steps.empty()) throw malformed(path);
  return steps;
}

SourcePosition position_of(const SourceValue& document, std::string_view path) {
  const SourceValue* value = &document;
  for (const PathStep& step : parse_path(path)) {
    const SourceValue* below = nullptr;
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      const auto* array = std::get_if<SourceArray>(&value->content);
      if (array != nullptr && *index < array->elements.size()) below = &array->elements[*index];
    } else if (const SourceMember* member = member_of(*value, std::get<std::string>(step))) {
      below = &member->value;
    }
    if (below == nullptr) break;
    value = below;
  }
  return value->where;
}

void merge(SourceValue& base, const SourceValue& changes) {
  auto* table = std::get_if<SourceTable>(&base.content);
  const auto* changed = std::get_if<SourceTable>(&changes.content);
  if (table == nullptr || changed == nullptr) {
    base = changes;
    return;
  }
  for (const SourceMember& member : changed->members) {
    if (SourceMember* existing = find(*table, member.key)) {
      existing->where = member.where;
      merge(existing->value, member.value);
    } else {
      table->members.push_back(member);
    }
  }
}

void put(SourceValue& document, std::string_view path, SourceValue value) {
  SourceValue* place = &document;
  for (const PathStep& step : parse_path(path)) place = &descend(*place, step, value.where);
  *place = std::move(value);
}

}  // namespace fissura::input
