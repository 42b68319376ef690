// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/meaningless_differences.hpp"

#include <algorithm>
#include <array>

namespace fissura::coupler {

namespace {

constexpr std::string_view process = "another process";
constexpr std::string_view solver = "who answers is told apart from what is answered";
constexpr std::string_view run = "another run of the same case";
constexpr std::string_view machine = "what the run was given of the machine; no result depends on it";
constexpr std::string_view wall = "wall time";

constexpr std::array table{MeaninglessDifference{MessageType::hello, "/pid", process},
                           MeaninglessDifference{MessageType::hello, "/solver", solver},
                           MeaninglessDifference{MessageType::hello, "/version", solver},
                           MeaninglessDifference{MessageType::hello, "/capabilities*", solver},
                           MeaninglessDifference{MessageType::hello, "/capabilities/*", solver},
                           MeaninglessDifference{MessageType::hello, "/physics*", solver},
                           MeaninglessDifference{MessageType::hello, "/physics/*", solver},
                           MeaninglessDifference{MessageType::welcome, "/run_id", run},
                           MeaninglessDifference{MessageType::welcome, "/threads", machine},
                           MeaninglessDifference{MessageType::welcome, "/coupler_deadline", machine},
                           MeaninglessDifference{MessageType::acknowledge, "/remeshing/*/wall_seconds", wall},
                           MeaninglessDifference{MessageType::bye, "/figures/*seconds", wall}};

/// `pattern` with any number of `*`.
bool fits(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern.front() != '*')
    return !text.empty() && pattern.front() == text.front() && fits(pattern.substr(1), text.substr(1));
  if (fits(pattern.substr(1), text)) return true;
  return !text.empty() && text.front() != '/' && fits(pattern, text.substr(1));
}

}  // namespace

std::span<const MeaninglessDifference> meaningless_differences() {
  return table;
}

bool is_meaningless(MessageType type, std::string_view entry) {
  return std::any_of(table.begin(), table.end(), [&](const MeaninglessDifference& each) {
    return each.type == type && fits(each.entry, entry);
  });
}

}  // namespace fissura::coupler
