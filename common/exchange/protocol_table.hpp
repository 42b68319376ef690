// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "common/exchange/message.hpp"
#include "common/exchange/role.hpp"

/// THE PROTOCOL as tables: what each side does with every message in every state. Participant
/// (participant.cpp) and coupler (coupler/launch/trio.cpp) look up here what to do; docs/protocol.md prints
/// these tables; the test of the model explores them. Every pair of state and message has an entry: an
/// action, or the fault that it is.
namespace fissura {

/// A message as the protocol tells it from others: its type, and whatever else decides what may follow.
enum class Word : std::uint8_t {
  hello,
  welcome,
  welcome_resuming,  ///< WELCOME with `resumes`
  reject,
  topology,
  insert,
  acknowledge,
  advance,
  pressure,
  response,
  proposal,  ///< RESPONSE with `insertion`
  report,
  fields,
  save,
  state,
  restore,
  restored,
  finish,
  bye,
  fail,
  progress
};
inline constexpr std::size_t word_count = 21;

Word word_of(const Message& message);
/// "HELLO", "WELCOME resuming", "RESPONSE proposing", ...
const char* name(Word word);

/// Why a message may not come, or may not be sent, in a state.
enum class ProtocolFault : std::uint8_t {
  wrong_direction,     ///< only the receiver's own side says this
  not_introduced,      ///< before HELLO and WELCOME
  introduced_twice,    ///< HELLO or WELCOME once more
  at_work,             ///< the last command has not been answered yet
  no_topology,         ///< the first INSERT has not come
  restore_expected,    ///< RESTORE must come first
  topology_exists,     ///< RESTORE to a participant that has a topology, or that does not resume
  insertion_proposed,  ///< the INSERT of a proposal must come first
  nothing_proposed,    ///< INSERT to a structure that has proposed nothing
  wrong_answer,        ///< not the answer to the last command
  unasked,             ///< an answer, and nothing was asked
  over                 ///< after BYE or FAIL
};
inline constexpr std::size_t fault_count = 12;

/// "wrong_direction", ...
const char* name(ProtocolFault fault);
/// The fault in words that go on from "INSERT came, but": "the solver is at work".
const char* sentence(ProtocolFault fault);

// ---- the participant --------------------------------------------------------------------------------

enum class ParticipantState : std::uint8_t {
  greeting,  ///< HELLO is sent
  joining,   ///< the solver is being built
  empty,     ///< no topology yet: INSERT of revision 0 comes first
  resuming,  ///< no topology yet: RESTORE comes first
  ready,     ///< may be asked anything
  proposed,  ///< the structure has proposed an insertion that has not come yet
  working,   ///< a command is being carried out
  leaving,   ///< BYE is sent
  failed,    ///< FAIL is sent
  ended
};
inline constexpr std::size_t participant_state_count = 10;
const char* name(ParticipantState state);

enum class ParticipantAction : std::uint8_t {
  join,
  insert,
  advance,
  report,
  save,
  restore,
  finish,
  keep,       ///< for the time after joining: the coupler does not hear when that is
  hear,       ///< nothing to do: the coupler lives
  ignore,     ///< said before the coupler knew of the failure
  accept_no,  ///< REJECT: end
  stop,       ///< the coupler ends the run: end
  leave       ///< the last word has arrived: end
};
inline constexpr std::size_t participant_action_count = 13;
const char* name(ParticipantAction action);

/// What a participant says when an action is done, and its state then.
struct ParticipantOutcome {
  std::optional<Word> reply;
  ParticipantState next = ParticipantState::ended;
};

/// An action and its outcomes: one, or two that the solver chooses between. Whatever works may also end in
/// FAIL and the state failed.
struct ParticipantStep {
  ParticipantAction action = ParticipantAction::ignore;
  std::array<ParticipantOutcome, 2> outcomes;
  std::size_t outcome_count = 1;
};

using ParticipantReaction = std::variant<ParticipantStep, ProtocolFault>;

/// What a participant does with a word from the coupler.
const ParticipantReaction& reaction(Role role, ParticipantState state, Word heard);

/// The state while `action` is carried out from `state`.
ParticipantState state_during(ParticipantAction action, ParticipantState state);

// ---- the coupler ------------------------------------------------------------------------------------

/// What the coupler knows of one participant.
enum class CouplerView : std::uint8_t {
  absent,     ///< has not said HELLO
  joining,    ///< the structure is being built: TOPOLOGY comes
  empty,      ///< welcomed, without topology
  resuming,   ///< welcomed, RESTORE owed
  idle,       ///< asked for nothing
  proposed,   ///< asked for nothing; the INSERT of its proposal is owed
  inserting,  ///< from here to finishing: asked, and its answer outstanding
  advancing,
  reporting,
  reporting_proposed,  ///< as reporting, with an INSERT owed
  saving,
  restoring,
  finishing,
  leaving,  ///< has said BYE
  failed,   ///< has said FAIL
  gone      ///< ended, or told that the run ends
};
inline constexpr std::size_t coupler_view_count = 16;
const char* name(CouplerView view);

enum class CouplerAction : std::uint8_t {
  greet,         ///< WELCOME, or REJECT if it may not take part
  take,          ///< the answer that was waited for
  release,       ///< take it, and return the BYE
  note,          ///< it gets on
  hear_failure,  ///< the run ends with its reason
  ignore
};
inline constexpr std::size_t coupler_action_count = 6;
const char* name(CouplerAction action);

struct CouplerStep {
  CouplerAction action = CouplerAction::ignore;
  CouplerView next = CouplerView::gone;
};

using CouplerReaction = std::variant<CouplerStep, ProtocolFault>;
/// The view after a word of the coupler's own, or why it may not be said.
using CouplerMove = std::variant<CouplerView, ProtocolFault>;

/// What the coupler does with a word from a participant it sees as `view`. A stranger is seen as what its
/// role is: a fault is its own then, and it is refused.
const CouplerReaction& reaction(Role role, CouplerView view, Word heard);
/// Whether the coupler may say `said` to a participant it sees as `view`.
const CouplerMove& move(Role role, CouplerView view, Word said);

/// Whether an answer is outstanding.
bool is_waited_for(CouplerView view);

}  // namespace fissura
