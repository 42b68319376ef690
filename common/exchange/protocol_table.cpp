// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/protocol_table.hpp"

#include <initializer_list>
#include <stdexcept>

#include "common/errors.hpp"

namespace fissura {

namespace {

/// Some values of an enumeration.
template <typename Enumeration>
struct Set {
  std::uint32_t bits = 0;

  constexpr Set(std::initializer_list<Enumeration> members) {
    for (const Enumeration member : members) bits |= bit(member);
  }
  [[nodiscard]] constexpr bool contains(Enumeration member) const { return (bits & bit(member)) != 0; }
  [[nodiscard]] constexpr Set operator|(Set other) const {
    other.bits |= bits;
    return other;
  }

 private:
  static constexpr std::uint32_t bit(Enumeration member) {
    return std::uint32_t{1} << static_cast<unsigned>(member);
  }
};

template <typename State, typename Entry>
struct Rule {
  Set<Role> roles;
  Set<State> states;
  Set<Word> words;
  Entry entry;
};

template <typename State, typename Entry, std::size_t state_count>
using Table = std::array<std::array<std::array<Entry, word_count>, state_count>, role_count>;

/// One entry for every pair: a pair without a rule, or with two, does not compile.
template <std::size_t state_count, typename State, typename Entry, std::size_t rule_count>
consteval Table<State, Entry, state_count> table_of(const Rule<State, Entry> (&rules)[rule_count]) {
  Table<State, Entry, state_count> table{};
  for (std::size_t role = 0; role < role_count; ++role)
    for (std::size_t state = 0; state < state_count; ++state)
      for (std::size_t word = 0; word < word_count; ++word) {
        int found = 0;
        for (const Rule<State, Entry>& rule : rules) {
          if (!rule.roles.contains(static_cast<Role>(role)) ||
              !rule.states.contains(static_cast<State>(state)) ||
              !rule.words.contains(static_cast<Word>(word)))
            continue;
          table[role][state][word] = rule.entry;
          ++found;
        }
        if (found != 1) throw std::logic_error("not exactly one rule");
      }
  return table;
}

constexpr Set<Role> structure{Role::structure}, network{Role::network}, both{Role::structure, Role::network};

using enum Word;
constexpr Set<Word> welcomes{welcome, welcome_resuming},
    commands{insert, advance, report, save, restore, finish},
    answers{topology, acknowledge, pressure, response, proposal, fields, state, restored},
    of_the_coupler_only = welcomes | commands | Set<Word>{reject},
    of_participants_only = answers | Set<Word>{hello};

// ---- the participant --------------------------------------------------------------------------------

using ParticipantRule = Rule<ParticipantState, ParticipantReaction>;
using enum ParticipantState;
using Does = ParticipantAction;
using Fault = ProtocolFault;

constexpr ParticipantReaction does(ParticipantAction action, ParticipantState next) {
  return ParticipantStep{action, {{{std::nullopt, next}, {}}}, 1};
}
constexpr ParticipantReaction does(ParticipantAction action, Word reply, ParticipantState next) {
  return ParticipantStep{action, {{{reply, next}, {}}}, 1};
}
constexpr ParticipantReaction does(ParticipantAction action, ParticipantOutcome one,
                                   ParticipantOutcome other) {
  return ParticipantStep{action, {{one, other}}, 2};
}

constexpr Set<ParticipantState> every_state{greeting, joining, empty,   resuming, ready,
                                            proposed, working, leaving, failed,   ended},
    having_topology{ready, proposed}, waiting = having_topology | Set<ParticipantState>{empty, resuming};

constexpr ParticipantRule participant_rules[] = {
    {both, every_state, of_participants_only, Fault::wrong_direction},

    {structure, {greeting}, {welcome}, does(Does::join, topology, empty)},
    {network, {greeting}, {welcome}, does(Does::join, empty)},
    {both, {greeting}, {welcome_resuming}, does(Does::join, resuming)},
    {both, {greeting}, {reject}, does(Does::accept_no, ended)},
    {both, {greeting}, commands | Set<Word>{bye, Word::fail, progress}, Fault::not_introduced},

    {structure, {joining}, {insert}, Fault::at_work},
    {network, {joining}, {insert}, does(Does::keep, joining)},
    {both, {joining}, {restore}, does(Does::keep, joining)},
    {both, {joining}, {advance, report, save, finish}, Fault::at_work},

    {both, {empty}, {insert}, does(Does::insert, acknowledge, ready)},
    {both, {empty}, {advance, report, save, finish}, Fault::no_topology},
    {both, {empty}, {restore}, Fault::topology_exists},

    {both, {resuming}, {restore}, does(Does::restore, restored, ready)},
    {both, {resuming}, {insert, advance, report, save, finish}, Fault::restore_expected},

    {structure, {ready}, {insert}, Fault::nothing_proposed},
    {network, {ready}, {insert}, does(Does::insert, acknowledge, ready)},
    {structure, {ready}, {advance}, does(Does::advance, {response, ready}, {proposal, proposed})},
    {network, {ready}, {advance}, does(Does::advance, pressure, ready)},
    {both, {ready}, {report}, does(Does::report, fields, ready)},
    {both, {ready}, {save}, does(Does::save, state, ready)},
    {both, {ready}, {finish}, does(Does::finish, bye, leaving)},

    {both, {proposed}, {insert}, does(Does::insert, acknowledge, ready)},
    {both, {proposed}, {report}, does(Does::report, fields, proposed)},
    {both, {proposed}, {advance, save, finish}, Fault::insertion_proposed},
    {both, having_topology, {restore}, Fault::topology_exists},

    {both, {working}, commands, Fault::at_work},

    {both, waiting | Set<ParticipantState>{joining, working}, welcomes | Set<Word>{reject},
     Fault::introduced_twice},
    {both, waiting | Set<ParticipantState>{joining, working}, {bye}, Fault::unasked},
    {both,
     waiting | Set<ParticipantState>{joining, working},
     {Word::fail},
     does(Does::stop, ended)},
    {both, {joining}, {progress}, does(Does::hear, joining)},
    {both, {empty}, {progress}, does(Does::hear, empty)},
    {both, {resuming}, {progress}, does(Does::hear, resuming)},
    {both, {ready}, {progress}, does(Does::hear, ready)},
    {both, {proposed}, {progress}, does(Does::hear, proposed)},
    {both, {working}, {progress}, does(Does::hear, working)},

    {both, {leaving}, of_the_coupler_only, Fault::over},
    {both, {leaving}, {progress}, does(Does::hear, leaving)},
    {both, {leaving, failed}, {bye, Word::fail}, does(Does::leave, ended)},
    {both, {failed}, of_the_coupler_only | Set<Word>{progress}, does(Does::ignore, failed)},
    {both, {ended}, of_the_coupler_only | Set<Word>{bye, Word::fail, progress}, Fault::over},
};

constexpr auto participant_table = table_of<participant_state_count>(participant_rules);

// ---- the coupler ------------------------------------------------------------------------------------

namespace hears {

using View = CouplerView;
using Hears = Rule<View, CouplerReaction>;

constexpr CouplerReaction take(View next) {
  return CouplerStep{CouplerAction::take, next};
}
constexpr CouplerReaction note(View next) {
  return CouplerStep{CouplerAction::note, next};
}
constexpr CouplerReaction ignore(View next) {
  return CouplerStep{CouplerAction::ignore, next};
}

constexpr Set<View> every_view{View::absent,    View::joining,  View::empty,     View::resuming,
                               View::idle,      View::proposed, View::inserting, View::advancing,
                               View::reporting, View::saving,   View::restoring, View::reporting_proposed,
                               View::finishing, View::leaving,  View::failed,    View::gone},
    unasked{View::empty, View::resuming, View::idle, View::proposed}, ended{View::failed, View::gone};
constexpr Set<View> asked{View::inserting, View::advancing, View::reporting, View::reporting_proposed,
                          View::saving,    View::restoring, View::finishing};

constexpr Hears rules[] = {
    {both, every_view, of_the_coupler_only, Fault::wrong_direction},

    {both, {View::absent}, {hello}, CouplerStep{CouplerAction::greet, View::absent}},
    {both, {View::absent}, answers | Set<Word>{bye, Word::fail, progress}, Fault::not_introduced},
    {both,
     unasked | asked | Set<View>{View::joining, View::leaving, View::failed},
     {hello},
     Fault::introduced_twice},
    {both, {View::gone}, {hello}, Fault::over},

    {structure, {View::joining}, {topology}, take(View::empty)},
    {network, {View::joining}, {topology}, Fault::wrong_answer},
    {both,
     {View::joining},
     {acknowledge, pressure, response, proposal, fields, state, restored, bye},
     Fault::wrong_answer},

    {both, unasked, answers | Set<Word>{bye}, Fault::unasked},

    {both, {View::inserting}, {acknowledge}, take(View::idle)},
    {both,
     {View::inserting},
     {topology, pressure, response, proposal, fields, state, restored, bye},
     Fault::wrong_answer},
    {structure, {View::advancing}, {response}, take(View::idle)},
    {structure, {View::advancing}, {proposal}, take(View::proposed)},
    {structure,
     {View::advancing},
     {topology, acknowledge, pressure, fields, state, restored, bye},
     Fault::wrong_answer},
    {network, {View::advancing}, {pressure}, take(View::idle)},
    {network,
     {View::advancing},
     {topology, acknowledge, response, proposal, fields, state, restored, bye},
     Fault::wrong_answer},
    {both, {View::reporting}, {fields}, take(View::idle)},
    {both, {View::reporting_proposed}, {fields}, take(View::proposed)},
    {both,
     {View::reporting, View::reporting_proposed},
     {topology, acknowledge, pressure, response, proposal, state, restored, bye},
     Fault::wrong_answer},
    {both, {View::saving}, {state}, take(View::idle)},
    {both,
     {View::saving},
     {topology, acknowledge, pressure, response, proposal, fields, restored, bye},
     Fault::wrong_answer},
    {both, {View::restoring}, {restored}, take(View::idle)},
    {both,
     {View::restoring},
     {topology, acknowledge, pressure, response, proposal, fields, state, bye},
     Fault::wrong_answer},
    {both, {View::finishing}, {bye}, CouplerStep{CouplerAction::release, View::leaving}},
    {both, {View::finishing}, answers, Fault::wrong_answer},

    {both,
     unasked | asked | Set<View>{View::joining, View::leaving},
     {Word::fail},
     CouplerStep{CouplerAction::hear_failure, View::failed}},
    {both, {View::joining}, {progress}, note(View::joining)},
    {both, {View::empty}, {progress}, note(View::empty)},
    {both, {View::resuming}, {progress}, note(View::resuming)},
    {both, {View::idle}, {progress}, note(View::idle)},
    {both, {View::proposed}, {progress}, note(View::proposed)},
    {both, {View::inserting}, {progress}, note(View::inserting)},
    {both, {View::advancing}, {progress}, note(View::advancing)},
    {both, {View::reporting}, {progress}, note(View::reporting)},
    {both, {View::reporting_proposed}, {progress}, note(View::reporting_proposed)},
    {both, {View::saving}, {progress}, note(View::saving)},
    {both, {View::restoring}, {progress}, note(View::restoring)},
    {both, {View::finishing}, {progress}, note(View::finishing)},

    {both, {View::leaving}, answers | Set<Word>{bye}, Fault::over},
    {both, {View::leaving}, {progress}, ignore(View::leaving)},
    {both, {View::failed}, answers | Set<Word>{bye, Word::fail, progress}, ignore(View::failed)},
    {both, {View::gone}, answers | Set<Word>{bye, Word::fail, progress}, ignore(View::gone)},
};

constexpr auto table = table_of<coupler_view_count>(rules);

}  // namespace hears

namespace says {

using hears::View;
using Says = Rule<View, CouplerMove>;

constexpr Set<View> having_topology{View::idle, View::proposed},
    asked = hears::asked | Set<View>{View::joining}, over{View::leaving, View::failed, View::gone};

constexpr Says rules[] = {
    {both, hears::every_view, of_participants_only, Fault::wrong_direction},

    {structure, {View::absent}, {welcome}, View::joining},
    {network, {View::absent}, {welcome}, View::empty},
    {both, {View::absent}, {welcome_resuming}, View::resuming},
    {both, {View::absent}, {reject}, View::absent},
    {both, {View::absent}, commands | Set<Word>{bye, Word::fail, progress}, Fault::not_introduced},
    {both, hears::unasked | asked | over, welcomes | Set<Word>{reject}, Fault::introduced_twice},

    {both, {View::empty}, {insert}, View::inserting},
    {both, {View::empty}, {advance, report, save, finish}, Fault::no_topology},
    {both, {View::empty}, {restore}, Fault::topology_exists},
    {both, {View::resuming}, {restore}, View::restoring},
    {both, {View::resuming}, {insert, advance, report, save, finish}, Fault::restore_expected},

    {structure, {View::idle}, {insert}, Fault::nothing_proposed},
    {network, {View::idle}, {insert}, View::inserting},
    {both, {View::idle}, {advance}, View::advancing},
    {both, {View::idle}, {report}, View::reporting},
    {both, {View::idle}, {save}, View::saving},
    {both, {View::idle}, {finish}, View::finishing},

    {both, {View::proposed}, {insert}, View::inserting},
    {both, {View::proposed}, {report}, View::reporting_proposed},
    {both, {View::proposed}, {advance, save, finish}, Fault::insertion_proposed},
    {both, having_topology, {restore}, Fault::topology_exists},

    {both, asked, commands, Fault::at_work},
    {both, over, commands, Fault::over},

    {both, hears::unasked | asked, {bye}, Fault::unasked},
    {both, {View::leaving}, {bye}, View::leaving},
    {both, {View::failed, View::gone}, {bye}, Fault::over},
    {both, hears::unasked | asked | Set<View>{View::leaving, View::failed}, {Word::fail}, View::gone},
    {both, {View::gone}, {Word::fail}, Fault::over},

    {both, {View::joining}, {progress}, View::joining},
    {both, {View::empty}, {progress}, View::empty},
    {both, {View::resuming}, {progress}, View::resuming},
    {both, {View::idle}, {progress}, View::idle},
    {both, {View::proposed}, {progress}, View::proposed},
    {both, {View::inserting}, {progress}, View::inserting},
    {both, {View::advancing}, {progress}, View::advancing},
    {both, {View::reporting}, {progress}, View::reporting},
    {both, {View::reporting_proposed}, {progress}, View::reporting_proposed},
    {both, {View::saving}, {progress}, View::saving},
    {both, {View::restoring}, {progress}, View::restoring},
    {both, {View::finishing}, {progress}, View::finishing},
    {both, over, {progress}, Fault::over},
};

constexpr auto table = table_of<coupler_view_count>(rules);

}  // namespace says

template <typename Enumeration>
constexpr std::size_t place(Enumeration value) {
  return static_cast<std::size_t>(value);
}

}  // namespace

const ParticipantReaction& reaction(Role role, ParticipantState state, Word heard) {
  return participant_table[place(role)][place(state)][place(heard)];
}

ParticipantState state_during(ParticipantAction action, ParticipantState state) {
  switch (action) {
    case Does::join:
      return joining;
    case Does::insert:
    case Does::advance:
    case Does::report:
    case Does::save:
    case Does::restore:
    case Does::finish:
      return working;
    case Does::keep:
    case Does::hear:
    case Does::ignore:
    case Does::accept_no:
    case Does::stop:
    case Does::leave:
      break;
  }
  return state;
}

const CouplerReaction& reaction(Role role, CouplerView view, Word heard) {
  return hears::table[place(role)][place(view)][place(heard)];
}

const CouplerMove& move(Role role, CouplerView view, Word said) {
  return says::table[place(role)][place(view)][place(said)];
}

bool is_waited_for(CouplerView view) {
  return says::asked.contains(view);
}

Word word_of(const Message& message) {
  switch (message.type) {
    case MessageType::hello:
      return hello;
    case MessageType::welcome: {
      const auto resumes = message.body.find("resumes");
      return resumes != message.body.end() && *resumes == true ? welcome_resuming : welcome;
    }
    case MessageType::reject:
      return reject;
    case MessageType::topology:
      return topology;
    case MessageType::insert:
      return insert;
    case MessageType::acknowledge:
      return acknowledge;
    case MessageType::advance:
      return advance;
    case MessageType::pressure:
      return pressure;
    case MessageType::response:
      return message.body.contains("insertion") ? proposal : response;
    case MessageType::report:
      return report;
    case MessageType::fields:
      return fields;
    case MessageType::save:
      return save;
    case MessageType::state:
      return state;
    case MessageType::restore:
      return restore;
    case MessageType::restored:
      return restored;
    case MessageType::finish:
      return finish;
    case MessageType::bye:
      return bye;
    case MessageType::fail:
      return Word::fail;
    case MessageType::progress:
      return progress;
  }
  throw ProtocolError("unknown message type " + std::to_string(static_cast<int>(message.type)));
}

}  // namespace fissura
