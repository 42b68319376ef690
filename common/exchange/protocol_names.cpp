// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "common/exchange/protocol_table.hpp"

namespace fissura {

namespace {

template <std::size_t count>
using Texts = std::array<const char*, count>;

constexpr Texts<word_count> words{"HELLO",
                                  "WELCOME",
                                  "WELCOME resuming",
                                  "REJECT",
                                  "TOPOLOGY",
                                  "INSERT",
                                  "ACKNOWLEDGE",
                                  "ADVANCE",
                                  "PRESSURE",
                                  "RESPONSE",
                                  "RESPONSE proposing",
                                  "REPORT",
                                  "FIELDS",
                                  "SAVE",
                                  "STATE",
                                  "RESTORE",
                                  "RESTORED",
                                  "FINISH",
                                  "BYE",
                                  "FAIL",
                                  "PROGRESS"};

constexpr Texts<fault_count> faults{
    "wrong_direction",  "not_introduced",   "introduced_twice", "at_work",
    "no_topology",      "restore_expected", "topology_exists",  "insertion_proposed",
    "nothing_proposed", "wrong_answer",     "unasked",          "over"};

constexpr Texts<fault_count> fault_sentences{"that is what the other side says",
                                             "it has not been introduced",
                                             "it has been introduced already",
                                             "the solver is at work",
                                             "the first topology has not come",
                                             "RESTORE has to come first",
                                             "it has a topology or is to begin one",
                                             "the insertion that is proposed has to come first",
                                             "no insertion was proposed",
                                             "that is not what it was asked for",
                                             "it was not asked",
                                             "its part in the run is over"};

constexpr Texts<participant_state_count> states{"greeting", "joining", "empty",   "resuming", "ready",
                                                "proposed", "working", "leaving", "failed",   "ended"};

constexpr Texts<participant_action_count> participant_actions{
    "join", "insert", "advance", "report",    "save", "restore", "finish",
    "keep", "hear",   "ignore",  "accept_no", "stop", "leave"};

constexpr Texts<coupler_view_count> views{
    "absent",   "joining",   "empty",     "resuming",  "idle",
    "proposed", "inserting", "advancing", "reporting", "reporting_proposed",
    "saving",   "restoring", "finishing", "leaving",   "failed",
    "gone"};

constexpr Texts<coupler_action_count> coupler_actions{"greet", "take",         "release",
                                                      "note",  "hear_failure", "ignore"};

template <std::size_t count, typename Enumeration>
const char* text(const Texts<count>& texts, Enumeration value) {
  return texts[static_cast<std::size_t>(value)];
}

}  // namespace

const char* name(Word word) {
  return text(words, word);
}
const char* name(ProtocolFault fault) {
  return text(faults, fault);
}
const char* sentence(ProtocolFault fault) {
  return text(fault_sentences, fault);
}
const char* name(ParticipantState state) {
  return text(states, state);
}
const char* name(ParticipantAction action) {
  return text(participant_actions, action);
}
const char* name(CouplerView view) {
  return text(views, view);
}
const char* name(CouplerAction action) {
  return text(coupler_actions, action);
}

}  // namespace fissura
