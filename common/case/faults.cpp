// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/faults.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fissura {

namespace {

FaultList in_order(FaultList faults) {
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.where.file, a.where.line, a.where.column) <
           std::tie(b.where.file, b.where.line, b.where.column);
  });
  return faults;
}

std::string report(const FaultList& faults) {
  std::string text =
      faults.size() == 1 ? "the case has a fault" : fmt::format("the case has {} faults", faults.size());
  text += ":";
  for (const Fault& fault : faults) text += "\n  " + describe(fault);
  return text;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, substituted}));
    }
  }
  return row[b.size()];
}

}  // namespace

SourcePosition whole(const std::string& file) {
  SourcePosition position;
  position.file = file;
  return position;
}

std::string describe(const Fault& fault) {
  std::string text = fault.where.file;
  if (fault.where.line > 0) text += fmt::format(":{}:{}", fault.where.line, fault.where.column);
  if (!fault.key.empty()) text += fmt::format(": {}", fault.key);
  text += fmt::format(": found {}, expected {}", fault.found, fault.expected);
  if (!fault.suggestion.empty()) text += fmt::format("; did you mean \"{}\"?", fault.suggestion);
  return text;
}

CaseFaults::CaseFaults(FaultList faults)
    : InputError(report(in_order(faults))), faults_(in_order(std::move(faults))) {}

std::string closest_word(std::string_view word, std::span<const std::string> allowed) {
  constexpr std::size_t longest_compared = 200, shortest_beginning = 3;
  if (word.size() > longest_compared) return {};
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::string closest;
  for (const std::string& candidate : allowed) {
    if (word.size() >= shortest_beginning && candidate.starts_with(word)) return candidate;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      closest = candidate;
    }
  }
  return closest;
}

std::string listed(std::span<const std::string> words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace fissura
