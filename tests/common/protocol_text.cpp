// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/protocol_text.hpp"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "common/exchange/protocol_table.hpp"

namespace fissura::test {

namespace {

/// One row of a table: what is taken in a state, and what is a fault.
struct Row {
  std::string taken, faults;
  bool operator==(const Row&) const = default;
};

/// Puts together the cells of one state; cells of the same text share a line.
class RowWriter {
 public:
  void take(Word word, const std::string& what) { add(taken_, what, word); }
  void fault(Word word, ProtocolFault fault) { add(faults_, name(fault), word); }
  [[nodiscard]] Row row() const { return {text(taken_), text(faults_)}; }

 private:
  using Cells = std::vector<std::pair<std::string, std::string>>;  ///< what, and for which messages

  static void add(Cells& cells, const std::string& what, Word word) {
    for (auto& [known, words] : cells)
      if (known == what) {
        words += std::string(", ") + name(word);
        return;
      }
    cells.emplace_back(what, name(word));
  }
  static std::string text(const Cells& cells) {
    std::string text;
    for (const auto& [what, words] : cells)
      text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", words, what);
    return text.empty() ? "-" : text;
  }

  Cells taken_, faults_;
};

std::string step_text(const ParticipantStep& step, ParticipantState state) {
  std::string text = fmt::format("*{}*", name(step.action));
  for (std::size_t i = 0; i < step.outcome_count; ++i) {
    const ParticipantOutcome& outcome = step.outcomes[i];
    text += i == 0 ? "" : " or";
    if (outcome.reply) text += fmt::format(" {}", name(*outcome.reply));
    if (outcome.next != state) text += fmt::format(" → `{}`", name(outcome.next));
  }
  return text;
}

bool is_wrong_direction(const auto& entry) {
  const auto* fault = std::get_if<ProtocolFault>(&entry);
  return fault != nullptr && *fault == ProtocolFault::wrong_direction;
}

Row participant_row(Role role, ParticipantState state) {
  RowWriter writer;
  for (std::size_t word = 0; word < word_count; ++word) {
    const ParticipantReaction& entry = reaction(role, state, static_cast<Word>(word));
    if (is_wrong_direction(entry)) continue;
    if (const auto* fault = std::get_if<ProtocolFault>(&entry))
      writer.fault(static_cast<Word>(word), *fault);
    else
      writer.take(static_cast<Word>(word), step_text(std::get<ParticipantStep>(entry), state));
  }
  return writer.row();
}

Row hearing_row(Role role, CouplerView view) {
  RowWriter writer;
  for (std::size_t word = 0; word < word_count; ++word) {
    const CouplerReaction& entry = reaction(role, view, static_cast<Word>(word));
    if (is_wrong_direction(entry)) continue;
    if (const auto* fault = std::get_if<ProtocolFault>(&entry)) {
      writer.fault(static_cast<Word>(word), *fault);
    } else {
      const auto& step = std::get<CouplerStep>(entry);
      const std::string next = step.next == view ? "" : fmt::format(" → `{}`", name(step.next));
      writer.take(static_cast<Word>(word), fmt::format("*{}*{}", name(step.action), next));
    }
  }
  return writer.row();
}

Row saying_row(Role role, CouplerView view) {
  RowWriter writer;
  for (std::size_t word = 0; word < word_count; ++word) {
    const CouplerMove& entry = move(role, view, static_cast<Word>(word));
    if (is_wrong_direction(entry)) continue;
    if (const auto* fault = std::get_if<ProtocolFault>(&entry)) {
      writer.fault(static_cast<Word>(word), *fault);
    } else {
      const CouplerView next = std::get<CouplerView>(entry);
      writer.take(static_cast<Word>(word), next == view ? "said" : fmt::format("→ `{}`", name(next)));
    }
  }
  return writer.row();
}

/// One line for each state, two where the roles differ.
template <typename State, std::size_t count>
std::string table(const char* head, const char* taken, Row (*row)(Role, State)) {
  std::string text = fmt::format("| {} | {} | faults |\n|---|---|---|\n", head, taken);
  for (std::size_t number = 0; number < count; ++number) {
    const auto state = static_cast<State>(number);
    const Row structure = row(Role::structure, state), network = row(Role::network, state);
    const auto add = [&](const char* of, const Row& cells) {
      text += fmt::format("| `{}`{} | {} | {} |\n", name(state), of, cells.taken, cells.faults);
    };
    if (structure == network) {
      add("", structure);
    } else {
      add(" (structure)", structure);
      add(" (network)", network);
    }
  }
  return text;
}

}  // namespace

std::string protocol_text() {
  std::string text =
      "**The participant hears.** What it does, what it answers, and its state then (the same if none is "
      "named). Whatever is work may also end in FAIL and `failed`;\n"
      "while it is done the state is `joining` or `working`.\n\n";
  text += table<ParticipantState, participant_state_count>("state", "message: *action*, answer → next state",
                                                           participant_row);
  text +=
      "\n**The coupler hears** from a participant it sees as ...; a stranger is seen as what the role it "
      "claims is, and is refused where that is a fault.\n\n";
  text += table<CouplerView, coupler_view_count>("view", "message: *action* → next view", hearing_row);
  text +=
      "\n**The coupler says** to a participant it sees as ...; a fault here would be its own defect, and "
      "ends the run before anything is sent.\n\n";
  text += table<CouplerView, coupler_view_count>("view", "message → next view", saying_row);
  text +=
      "\nWhat only the other side says is `wrong_direction` in every state. The faults:\n\n| fault | it "
      "came, or would be said, but |\n|---|---|\n";
  for (std::size_t fault = 0; fault < fault_count; ++fault)
    text += fmt::format("| `{}` | {} |\n", name(static_cast<ProtocolFault>(fault)),
                        sentence(static_cast<ProtocolFault>(fault)));
  return text;
}

std::string with_protocol_text(const std::string& page) {
  const std::size_t begin = page.find(protocol_text_begin), end = page.find(protocol_text_end);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw std::runtime_error("the page has no block for the tables of the protocol");
  return page.substr(0, begin) + protocol_text_begin + protocol_text() + page.substr(end);
}

std::string content_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) throw std::runtime_error("cannot read " + file);
  return content.str();
}

}  // namespace fissura::test
