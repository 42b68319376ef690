// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/message_fault.hpp"

namespace fissura::coupler {

namespace {

constexpr double longest_pause = 86400;
constexpr double largest_frame = 8e9;
constexpr std::uint16_t greatest_type = 255;

/// The names of the protocol, in its order.
const std::vector<Named<MessageType>>& message_types() {
  static const std::vector<Named<MessageType>> types = [] {
    std::vector<Named<MessageType>> known;
    for (std::uint16_t number = 0; number <= greatest_type; ++number) {
      const auto type = static_cast<MessageType>(number);
      if (const std::string_view word = name(type); word != "UNKNOWN") known.push_back({word, type});
    }
    return known;
  }();
  return types;
}

std::optional<MessageType> read_type(input::TableReader& table) {
  if (!table.has("type")) return std::nullopt;
  std::vector<std::string> words;
  for (const Named<MessageType>& each : message_types()) words.emplace_back(each.name);
  const std::string word = table.word("type", words);
  for (const Named<MessageType>& each : message_types())
    if (each.name == word) return each.value;
  return std::nullopt;
}

std::optional<std::uint64_t> optional_number(input::TableReader& table, const char* key) {
  if (!table.has(key)) return std::nullopt;
  return table.natural_number(key, 0);
}

void read_poison(input::TableReader& table, MessageFault& fault) {
  if (table.has("entry")) {
    fault.entry = table.text("entry");
    if (!fault.entry.starts_with("/"))
      table.refuse("entry", R"(a place in the body such as "/ledger/injected")");
  } else {
    fault.field = table.text("field");
    fault.index = table.natural_number("index", 0);
  }
  fault.value = table.any_number("value");
}

void read_stamp(input::TableReader& table, MessageFault& fault) {
  fault.stamp = table.choice("stamp", stamp_fields).value_or(fault.stamp);
  if (table.has("shift"))
    fault.shift = table.whole_number("shift", input::any_value);
  else
    fault.stamp_value = table.natural_number("value", 0);
  if (!table.has("value") && !table.has("shift")) table.refuse("value", "value, or shift, a number to add");
}

void read_details(input::TableReader& table, MessageFault& fault) {
  switch (fault.action) {
    case MessageAction::drop:
    case MessageAction::duplicate:
    case MessageAction::swap:
    case MessageAction::cut:
    case MessageAction::half_open:
      return;
    case MessageAction::delay:
    case MessageAction::clog:
      fault.seconds = table.number("seconds", {0, longest_pause, false, true});
      return;
    case MessageAction::truncate:
      fault.frame = optional_number(table, "frame");
      fault.bytes = optional_number(table, "bytes");
      return;
    case MessageAction::flip:
      fault.frame = optional_number(table, "frame");
      fault.bit = table.natural_number("bit", 0);
      return;
    case MessageAction::resize:
      fault.field = table.text("field");
      fault.length = static_cast<std::uint64_t>(table.whole_number("length", input::from_to(0, largest_frame / 8)));
      return;
    case MessageAction::restamp:
      read_stamp(table, fault);
      return;
    case MessageAction::poison:
      read_poison(table, fault);
      return;
    case MessageAction::relabel:
      fault.field = table.text("field");
      fault.unit = table.text("unit");
      return;
    case MessageAction::replay:
      fault.back = static_cast<std::uint64_t>(table.count("back", input::at_least(1), 1));
      fault.as = table.choice("as", replay_kinds, fault.as);
      return;
    case MessageAction::oversize:
    case MessageAction::nonsense:
      fault.bytes = static_cast<std::uint64_t>(table.whole_number("bytes", input::from_to(0, largest_frame)));
      return;
    case MessageAction::slow:
      fault.bytes_per_second = table.number("bytes_per_second", input::positive);
      return;
  }
}

}  // namespace

std::vector<MessageFault> read_message_faults(input::TableReader& document) {
  std::vector<MessageFault> faults;
  for (input::TableReader& table : document.optional_tables("message")) {
    MessageFault& fault = faults.emplace_back();
    fault.role = table.word("role", {"structure", "network"});
    fault.direction = table.choice("direction", directions).value_or(fault.direction);
    fault.type = read_type(table);
    fault.interval = table.natural_number_or_every("interval", std::nullopt);
    fault.epoch = table.natural_number_or_every("epoch", fault.epoch);
    fault.occurrence = static_cast<std::uint64_t>(table.count("occurrence", input::at_least(1), 1));
    const std::optional<MessageAction> action = table.choice("do", message_actions);
    if (!action) continue;
    fault.action = *action;
    read_details(table, fault);
    table.refuse_unknown_keys();
  }
  return faults;
}

}  // namespace fissura::coupler
