// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstdio>

#include "tests/common/protocol_model.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

std::string kinds_of(const Exploration& exploration) {
  std::string text;
  for (const auto& [kind, example] : exploration.findings) text += kind + ": " + example + "\n";
  return text;
}

void check_sound(const Exploration& found) {
  INFO(kinds_of(found));
  CHECK(found.findings.empty());
  CHECK(found.complete == 1);
}

}  // namespace

TEST_CASE(
    "whatever fault strikes when, the run ends with it told, or goes on; no insertion is lost or made twice",
    "[common][exchange][model]") {
  const Exploration undisturbed = explore(real_tables(), {.faults = 0});
  const Exploration once = explore(real_tables(), {.faults = 1});
  const Exploration twice = explore(real_tables(), {.faults = 2});
  std::printf("model of the trio: %zu states without a fault, %zu with one, %zu with two\n",
              undisturbed.states, once.states, twice.states);
  check_sound(undisturbed);
  check_sound(once);
  check_sound(twice);
  // A run that is taken up once survives one fault, whatever it is.
  CHECK(undisturbed.failed + once.failed == 0);
  CHECK(twice.failed == 1);
}

TEST_CASE("the model finds an INSERT that is not acknowledged", "[common][exchange][model]") {
  ProtocolTables tables = real_tables();
  tables.participant = [](Role role, ParticipantState state, Word word) -> ParticipantReaction {
    if (role == Role::network && state == ParticipantState::ready && word == Word::insert)
      return ParticipantStep{ParticipantAction::hear, {{{std::nullopt, ParticipantState::ready}, {}}}, 1};
    return reaction(role, state, word);
  };
  CHECK(explore(tables, {}).findings.contains("deadlock"));
}

TEST_CASE("the model finds a proposal that is forgotten over a report", "[common][exchange][model]") {
  ProtocolTables tables = real_tables();
  tables.coupler_hears = [](Role role, CouplerView view, Word word) -> CouplerReaction {
    if (view == CouplerView::reporting_proposed && word == Word::fields)
      return CouplerStep{CouplerAction::take, CouplerView::idle};
    return reaction(role, view, word);
  };
  CHECK(explore(tables, {}).findings.contains("refused by the own table"));
}

TEST_CASE("the model finds that a repeated INSERT would be made twice", "[common][exchange][model]") {
  ProtocolTables tables = real_tables();
  tables.coupler_says = [](Role role, CouplerView view, Word word) -> CouplerMove {
    if (view == CouplerView::inserting && word == Word::insert) return CouplerView::inserting;
    return move(role, view, word);
  };
  CHECK(explore(tables, {.insists = true}).findings.contains("inserted twice"));
}

TEST_CASE("the model finds an advance that goes past an insertion", "[common][exchange][model]") {
  ProtocolTables tables = real_tables();
  tables.participant = [](Role role, ParticipantState state, Word word) -> ParticipantReaction {
    if (role == Role::network && state == ParticipantState::ready && word == Word::insert)
      return ParticipantStep{
          ParticipantAction::report, {{{Word::acknowledge, ParticipantState::ready}, {}}}, 1};
    return reaction(role, state, word);
  };
  CHECK(explore(tables, {}).findings.contains("insertion lost"));
}
