// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/message_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "common/errors.hpp"
#include "coupler/tape/meaningless_differences.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;

struct Declaration {
  std::string name, dtype, unit;
  std::vector<std::uint64_t> shape;

  bool operator==(const Declaration&) const = default;
  [[nodiscard]] std::string words() const {
    std::string extents;
    for (const std::uint64_t extent : shape)
      extents += fmt::format("{}{}", extents.empty() ? "" : " x ", extent);
    return fmt::format("{} {} [{}] in {}", dtype, name, extents, unit);
  }
};

json body_of(const Frames& message) {
  if (message.size() < 2) return {};
  const auto* text = reinterpret_cast<const char*>(message[1].data());
  return json::parse(text, text + message[1].size(), nullptr, false);
}

std::vector<Declaration> declarations_of(const json& body) {
  std::vector<Declaration> found;
  const auto arrays = body.is_object() ? body.find("arrays") : body.end();
  if (!body.is_object() || arrays == body.end() || !arrays->is_array()) return found;
  for (const json& each : *arrays) {
    try {
      found.push_back({each.at("name"), each.at("dtype"), each.at("unit"),
                       each.at("shape").get<std::vector<std::uint64_t>>()});
    } catch (const json::exception&) {
      found.push_back({"unreadable", each.dump(), "", {}});
    }
  }
  return found;
}

template <typename T>
T value_at(const std::vector<std::byte>& frame, std::uint64_t index) {
  T value;
  std::memcpy(&value, frame.data() + index * sizeof(T), sizeof(T));
  return value;
}

std::string digits(double value) {
  return fmt::format("{:.17g}", value);
}

std::string digits(const std::vector<std::byte>& frame, const std::string& dtype, std::uint64_t index) {
  if (dtype == "float64") return digits(value_at<double>(frame, index));
  if (dtype == "int64") return fmt::format("{}", value_at<std::int64_t>(frame, index));
  if (dtype == "uint64") return fmt::format("{}", value_at<std::uint64_t>(frame, index));
  return fmt::format("{}", value_at<std::uint8_t>(frame, index));
}

std::string indexed(const Declaration& array, std::uint64_t index, std::uint64_t columns) {
  return array.shape.size() < 2 ? fmt::format("{}[{}]", array.name, index)
                                : fmt::format("{}[{}, {}]", array.name, index / columns, index % columns);
}

void measure(MessageDifference& difference, double first, double second) {
  difference.ulps = ulps_between(first, second);
  difference.distance = std::abs(second - first);
}

/// Beyond rounding nobody counts the doubles between.
std::string distance_in_words(const MessageDifference& difference) {
  constexpr std::uint64_t beyond_rounding = 1'000'000;
  if (!difference.ulps) return "";
  return *difference.ulps < beyond_rounding ? fmt::format("  ({} ulp apart)", *difference.ulps)
                                            : fmt::format("  ({:.2g} apart)", difference.distance);
}

/// Gathers the first difference and counts all.
class Comparison {
 public:
  Comparison(const Frames& first, const Frames& second) : first_(first), second_(second) {}

  std::optional<MessageDifference> run() {
    const Envelope a = envelope_of(first_), b = envelope_of(second_);
    note_if_other("type", name(a.type), name(b.type));
    note_if_other("interval", fmt::format("{}", a.interval), fmt::format("{}", b.interval));
    note_if_other("revision", fmt::format("{}", a.revision), fmt::format("{}", b.revision));
    if (a.type != b.type) return found_;
    json body_a = body_of(first_), body_b = body_of(second_);
    const bool same_arrays = compare_declarations(declarations_of(body_a), declarations_of(body_b));
    if (same_arrays) compare_arrays(declarations_of(body_a));
    compare_bodies(a.type, std::move(body_a), std::move(body_b));
    return found_;
  }

 private:
  void note(MessageDifference&& difference) {
    if (found_)
      ++found_->places;
    else
      found_ = std::move(difference);
  }

  void note_if_other(const std::string& where, const std::string& first, const std::string& second) {
    if (first != second)
      note({.where = where, .first = first, .second = second, .ulps = {}, .distance = 0, .array = {}});
  }

  bool compare_declarations(const std::vector<Declaration>& a, const std::vector<Declaration>& b) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      const std::string none = "no such array";
      note_if_other(fmt::format("array {}", i + 1), i < a.size() ? a[i].words() : none,
                    i < b.size() ? b[i].words() : none);
    }
    note_if_other("number of frames", fmt::format("{}", first_.size()), fmt::format("{}", second_.size()));
    return a == b && first_.size() == second_.size() && first_.size() == a.size() + 2;
  }

  void compare_arrays(const std::vector<Declaration>& arrays) {
    for (std::size_t i = 0; i < arrays.size(); ++i)
      if (first_[i + 2] != second_[i + 2]) compare_array(arrays[i], first_[i + 2], second_[i + 2]);
  }

  void compare_array(const Declaration& array, const std::vector<std::byte>& a,
                     const std::vector<std::byte>& b) {
    if (a.size() != b.size()) {
      note_if_other(array.name, fmt::format("{} bytes", a.size()), fmt::format("{} bytes", b.size()));
      return;
    }
    const std::size_t size = array.dtype == "uint8" ? 1 : 8;
    std::uint64_t columns = 1;
    for (std::size_t i = 1; i < array.shape.size(); ++i)
      columns *= std::max<std::uint64_t>(1, array.shape[i]);
    std::optional<std::uint64_t> where;
    std::uint64_t count = 0;
    for (std::uint64_t i = 0; (i + 1) * size <= a.size(); ++i) {
      if (std::memcmp(a.data() + i * size, b.data() + i * size, size) == 0) continue;
      if (!where) where = i;
      ++count;
    }
    if (!where) return;
    MessageDifference difference{.where = indexed(array, *where, columns),
                                 .first = digits(a, array.dtype, *where),
                                 .second = digits(b, array.dtype, *where),
                                 .ulps = {},
                                 .distance = 0,
                                 .array = array.name,
                                 .row = *where / columns,
                                 .values = count};
    if (array.dtype == "float64")
      measure(difference, value_at<double>(a, *where), value_at<double>(b, *where));
    note(std::move(difference));
  }

  void compare_bodies(MessageType type, json&& a, json&& b) {
    for (json* body : {&a, &b})
      if (body->is_object()) body->erase("arrays");
    std::map<std::string, std::pair<json, json>> entries;
    const json flat_a = a.flatten(), flat_b = b.flatten();
    for (const auto& [entry, value] : flat_a.items()) entries[entry].first = value;
    for (const auto& [entry, value] : flat_b.items()) entries[entry].second = value;
    for (const auto& [entry, values] : entries) {
      const auto& [x, y] = values;
      if (x.type() == y.type() && x.dump() == y.dump()) continue;
      if (is_meaningless(type, entry)) continue;
      const bool in_a = flat_a.contains(entry), in_b = flat_b.contains(entry);
      MessageDifference difference{.where = entry,
                                   .first = in_a ? text_of(x) : "nothing",
                                   .second = in_b ? text_of(y) : "nothing",
                                   .ulps = {},
                                   .distance = 0,
                                   .array = {}};
      if (x.is_number() && y.is_number()) measure(difference, x.get<double>(), y.get<double>());
      note(std::move(difference));
    }
  }

  static std::string text_of(const json& value) {
    return value.is_number_float() ? digits(value.get<double>()) : value.dump();
  }

  const Frames& first_;
  const Frames& second_;
  std::optional<MessageDifference> found_;
};

bool same_but_for_the_stamp(const Frames& first, const Frames& second) {
  if (first.size() != second.size() || first.size() < 2) return false;
  if (!std::equal(first.begin() + 1, first.end(), second.begin() + 1)) return false;
  const Envelope a = envelope_of(first), b = envelope_of(second);
  return a.type == b.type && a.interval == b.interval && a.revision == b.revision;
}

}  // namespace

std::optional<MessageDifference> difference(const Frames& first, const Frames& second) {
  if (same_but_for_the_stamp(first, second)) return std::nullopt;
  return Comparison(first, second).run();
}

std::string in_words(const MessageDifference& difference, const std::string& place, const Sides& sides) {
  const std::size_t width = std::max(sides.first.size(), sides.second.size());
  std::string text = fmt::format("  {}{}{}\n", difference.where, place.empty() ? "" : ", ", place);
  text += fmt::format("    {:<{}}  {}\n", sides.first, width, difference.first);
  text += fmt::format("    {:<{}}  {}{}\n", sides.second, width, difference.second,
                      distance_in_words(difference));
  if (difference.values > 1) text += fmt::format("    {} values of this array differ\n", difference.values);
  if (difference.places > 1)
    text += fmt::format("    {} arrays or entries of this message differ\n", difference.places);
  return text;
}

std::string title_of(const Frames& message) {
  const Envelope envelope = envelope_of(message);
  return fmt::format("{} of interval {}", name(envelope.type), envelope.interval);
}

Envelope envelope_of(const Frames& message) {
  try {
    if (!message.empty()) return decode_envelope(message[0]);
  } catch (const ProtocolError&) {
  }
  return {};
}

std::uint64_t ulps_between(double first, double second) {
  // The order of doubles is that of their bits, counted down from zero for negative ones.
  const auto place = [](double value) {
    const auto bits = std::bit_cast<std::int64_t>(value);
    return bits < 0 ? static_cast<__int128>(INT64_MIN) - bits - 1 : static_cast<__int128>(bits);
  };
  const __int128 distance = place(first) - place(second);
  return static_cast<std::uint64_t>(distance < 0 ? -distance : distance);
}

}  // namespace fissura::coupler
