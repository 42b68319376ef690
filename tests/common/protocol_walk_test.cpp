// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "common/errors.hpp"
#include "common/exchange/protocol_table.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "tests/common/lone_participant.hpp"
#include "tests/common/some_words.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

/// Holds its session in the state it is asked for: joins or advances only when it is let go, and proposes if
/// it is to.
class HeldSolver : public Solver {
 public:
  void join(const Assignment&) override { wait(held_in_join); }
  Insertion first_topology() override {
    network_.apply(insertion_of_revision(0));
    return insertion_of_revision(0);
  }
  Message advance(const Message&) override {
    wait(held_in_advance);
    Message answer;
    if (proposes) answer.body["insertion"] = insertion_to_json(insertion_of_revision(1));
    return answer;
  }
  std::string insert(const Insertion& insertion) override {
    network_.apply(insertion);
    return network_.topology_hash();
  }
  Message report(const Message&) override { return {}; }
  std::vector<std::byte> save() override { return {}; }
  std::optional<std::string> restore(const std::vector<std::byte>&) override { return {}; }

  std::atomic<bool> held_in_join = false, held_in_advance = false, proposes = false, is_held = false;
  std::atomic<bool> may_look = false;  ///< at what the coupler has said

 private:
  void wait(const std::atomic<bool>& held) {
    while (held) {
      is_held = true;
      if (may_look) note_progress("held");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    is_held = false;
  }
  FractureNetwork network_;
};

/// A real Session in a given state.
class Walker {
 public:
  Walker(Role role, ParticipantState state) : participant_(role, prepared(solver_, state)) {
    if (state == ParticipantState::greeting) return;
    participant_.send(
        message_of(state == ParticipantState::resuming ? Word::welcome_resuming : Word::welcome));
    if (state == ParticipantState::joining) {
      wait_until_held();
      return;
    }
    if (role == Role::structure && state != ParticipantState::resuming)
      CHECK(participant_.receive().type == MessageType::topology);
    if (state == ParticipantState::failed) {
      CHECK(participant_.request(message_of(Word::advance)).type == MessageType::fail);
      return;
    }
    if (state == ParticipantState::empty || state == ParticipantState::resuming) return;
    CHECK(participant_.request(message_of(Word::insert)).type == MessageType::acknowledge);
    if (state == ParticipantState::ready) return;
    if (state == ParticipantState::leaving) {
      CHECK(participant_.request(message_of(Word::finish)).type == MessageType::bye);
      return;
    }
    participant_.send(message_of(Word::advance));
    if (state == ParticipantState::working) {
      wait_until_held();
      return;
    }
    CHECK(participant_.receive().body.contains("insertion"));
  }
  ~Walker() { let_go(); }
  Walker(const Walker&) = delete;
  Walker& operator=(const Walker&) = delete;

  /// Says `word`; a solver at work hears it while it is held.
  void say(Word word, std::uint64_t revision) {
    participant_.send(message_of(word, revision));
    solver_.may_look = true;
  }
  Message receive() { return participant_.receive(); }
  int end() { return participant_.end(); }
  void let_go() { solver_.held_in_join = solver_.held_in_advance = false; }

 private:
  static HeldSolver& prepared(HeldSolver& solver, ParticipantState state) {
    solver.held_in_join = state == ParticipantState::joining;
    solver.held_in_advance = state == ParticipantState::working;
    solver.proposes = state == ParticipantState::proposed;
    return solver;
  }
  void wait_until_held() const {
    while (!solver_.is_held) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  HeldSolver solver_;
  LoneParticipant participant_;
};

std::string reason_of(const Message& failure) {
  CHECK(failure.type == MessageType::fail);
  CHECK(failure.value<int>("exit_code") == static_cast<int>(ExitCode::protocol_violation));
  return failure.value<std::string>("reason");
}

/// Any state tells its name when it hears what no coupler says.
void check_state(Walker& walker, ParticipantState expected) {
  walker.say(Word::hello, 0);
  CHECK_THAT(reason_of(walker.receive()),
             Catch::Contains(std::string("state ") + name(expected) + ", fault wrong_direction"));
}

void check_step(Walker& walker, const ParticipantStep& step) {
  const ParticipantOutcome& outcome = step.outcomes[0];
  switch (step.action) {
    case ParticipantAction::accept_no:
      CHECK(walker.end() == static_cast<int>(ExitCode::mismatch));
      return;
    case ParticipantAction::stop:
      CHECK(walker.end() == static_cast<int>(ExitCode::participant_died));
      return;
    case ParticipantAction::leave:
      CHECK_NOTHROW(walker.end());
      return;
    case ParticipantAction::ignore:
      walker.say(Word::bye, 0);
      CHECK(walker.end() == static_cast<int>(ExitCode::protocol_violation));
      return;
    case ParticipantAction::keep:
    case ParticipantAction::join:
    case ParticipantAction::insert:
    case ParticipantAction::advance:
    case ParticipantAction::report:
    case ParticipantAction::save:
    case ParticipantAction::restore:
    case ParticipantAction::finish:
    case ParticipantAction::hear:
      break;
  }
  if (outcome.reply) CHECK(word_of(walker.receive()) == *outcome.reply);
  check_state(walker, outcome.next);
}

void walk(Role role, ParticipantState state) {
  for (std::size_t number = 0; number < word_count; ++number) {
    const auto word = static_cast<Word>(number);
    CAPTURE(name(role), name(state), name(word));
    Walker walker(role, state);
    walker.say(word, state == ParticipantState::proposed || state == ParticipantState::ready ? 1 : 0);
    const ParticipantReaction& rule = reaction(role, state, word);
    if (const auto* fault = std::get_if<ProtocolFault>(&rule)) {
      if (state == ParticipantState::greeting) {
        // It does not know its run yet, so that its channel refuses the message, and nobody would take its
        // FAIL.
        walker.say(Word::bye, 0);
        CHECK(walker.end() == static_cast<int>(ExitCode::protocol_violation));
      } else if (state != ParticipantState::failed) {
        CHECK_THAT(reason_of(walker.receive()),
                   Catch::Contains(std::string("state ") + name(state) + ", fault " + name(*fault)));
      }
    } else {
      check_step(walker, std::get<ParticipantStep>(rule));
    }
  }
}

constexpr ParticipantState states_of_both[] = {ParticipantState::greeting, ParticipantState::joining,
                                               ParticipantState::empty,    ParticipantState::resuming,
                                               ParticipantState::ready,    ParticipantState::working,
                                               ParticipantState::leaving,  ParticipantState::failed};

}  // namespace

TEST_CASE("a structure does with every message in every state what the table says",
          "[common][exchange][table]") {
  for (const ParticipantState state : states_of_both) walk(Role::structure, state);
  walk(Role::structure, ParticipantState::proposed);
}

TEST_CASE("a network does with every message in every state what the table says",
          "[common][exchange][table]") {
  for (const ParticipantState state : states_of_both) walk(Role::network, state);
}
