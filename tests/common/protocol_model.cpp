// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/protocol_model.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <deque>
#include <type_traits>
#include <unordered_set>
#include <vector>

namespace fissura::test {

namespace {

constexpr int queue_length = 3;
constexpr std::int8_t none = -1;

/// A message on its way.
struct Item {
  Word word = Word::progress;
  std::int8_t revision = none;
  std::uint8_t after_gap = 0;  ///< the message before it was lost
};

struct Queue {
  std::array<Item, queue_length> items;
  std::uint8_t size = 0;
  std::uint8_t gap = 0;  ///< the last message sent was lost

  [[nodiscard]] bool has_room() const { return size < queue_length; }
  void push(Item item) {
    item.after_gap = gap;
    gap = 0;
    items[size++] = item;
  }
  Item pop() {
    const Item first = items[0];
    for (int i = 1; i < queue_length; ++i) items[i - 1] = items[i];
    items[--size] = Item{};
    return first;
  }
  void lose_last() {
    items[--size] = Item{};
    gap = 1;
  }
};

/// Where the coupler's scheme is.
enum class Place : std::uint8_t {
  greeting,
  first_topology,
  first_insertion,
  restoring,
  between,
  network,
  structure,
  after_structure,
  reporting,
  inserting,
  accepted,
  saving,
  finishing,
  complete,
  failed
};

struct Participant {
  ParticipantState state = ParticipantState::greeting;
  ParticipantState before = ParticipantState::greeting;  ///< the work at hand was begun
  Word command = Word::hello;                            ///< the work at hand
  std::int8_t command_revision = none;
  std::int8_t revision = none;  ///< of its network
  std::uint8_t keeps = 0;       ///< a command for the time after joining
  Item kept;
  std::uint8_t alive = 1, stalled = 0;
};

struct State {
  std::array<Participant, 2> participants;
  std::array<Queue, 2> to_participant, to_coupler;
  std::array<CouplerView, 2> views{};
  std::array<Word, 2> answers{};
  std::array<std::uint8_t, 2> answered{};
  Place place = Place::greeting;
  std::int8_t revision = none, proposed = 0, interval = 0;
  std::int8_t checkpoint_revision = none, checkpoint_interval = none;
  std::uint8_t faults = 0, lives = 1;
};
static_assert(std::is_trivially_copyable_v<State> && std::has_unique_object_representations_v<State>);

std::string key_of(const State& state) {
  std::string key(sizeof(State), '\0');
  std::memcpy(key.data(), &state, sizeof(State));
  return key;
}

class Explorer {
 public:
  Explorer(const ProtocolTables& tables, const ModelOptions& options) : tables_(tables), options_(options) {}

  Exploration run() {
    reach(life(State{}));
    while (!waiting_.empty()) {
      State state;
      std::memcpy(static_cast<void*>(&state), waiting_.front()->data(), sizeof(State));
      waiting_.pop_front();
      if (state.place == Place::complete)
        ++found_.complete;
      else if (state.place == Place::failed)
        ++found_.failed;
      else
        expand(state);
    }
    found_.states = seen_.size();
    return found_;
  }

 private:
  void reach(const State& state) {
    const auto [key, is_new] = seen_.insert(key_of(state));
    if (is_new) waiting_.push_back(&*key);
  }

  void finding(const char* kind, const State& state, const std::string& detail) {
    found_.findings.try_emplace(
        kind, detail + " (place " + std::to_string(static_cast<int>(state.place)) + ", structure " +
                  name(state.participants[0].state) + " seen as " + name(state.views[0]) + ", network " +
                  name(state.participants[1].state) + " seen as " + name(state.views[1]) + ", faults " +
                  std::to_string(state.faults) + ")");
  }

  /// A run that begins, or takes up its checkpoint.
  static State life(State last) {
    State state;
    state.faults = last.faults;
    state.lives = last.lives;
    state.checkpoint_revision = last.checkpoint_revision;
    state.checkpoint_interval = last.checkpoint_interval;
    for (int r = 0; r < 2; ++r) state.to_coupler[r].push({Word::hello});
    return state;
  }
  static bool resumes(const State& state) { return state.checkpoint_interval != none; }

  /// The run ends with a fault told; it goes on from its checkpoint if it may.
  void end(const State& state) {
    if (state.lives < options_.lives) {
      State next = state;
      ++next.lives;
      reach(life(next));
    } else {
      State next;
      next.place = Place::failed;
      reach(next);
    }
  }
  /// A fault that somebody found. Nobody may find one where nothing has happened.
  void end_by_fault(const State& state, const std::string& detail) {
    if (state.faults == 0) finding("fault without a cause", state, detail);
    end(state);
  }

  // ---- successors -----------------------------------------------------------------------------------

  void expand(const State& state) {
    steps_ = 0;
    for (int r = 0; r < 2; ++r) {
      participant_hears(state, r);
      participant_completes(state, r);
      participant_notes(state, r);
      coupler_hears(state, r);
      coupler_sees_end(state, r);
    }
    scheme(state);
    const bool stuck = steps_ == 0;
    for (int r = 0; r < 2; ++r) coupler_notes(state, r);
    if (state.faults < options_.faults) faults(state);
    if (!stuck) return;
    // Only a deadline leads on from here; where nothing has happened, nobody should have to wait for one.
    if (state.faults == 0) finding("deadlock", state, "everybody waits");
    if (options_.insists && state.place == Place::inserting) insist(state);
    end(state);
  }
  void step(const State& next) {
    ++steps_;
    reach(next);
  }

  void participant_fails(State state, int r) {
    state.participants[r].state = ParticipantState::failed;
    if (state.to_coupler[r].has_room()) state.to_coupler[r].push({Word::fail});
    step(state);
  }

  void participant_hears(const State& before, int r) {
    const Participant& self = before.participants[r];
    if (!self.alive || self.stalled || self.state == ParticipantState::ended) return;
    const bool at_work = self.state == ParticipantState::working || self.state == ParticipantState::joining;
    const bool takes_kept = self.keeps && !at_work;
    if (!takes_kept && before.to_participant[r].size == 0) return;
    State state = before;
    Participant& next = state.participants[r];
    const Item item = takes_kept ? next.kept : state.to_participant[r].pop();
    if (takes_kept) next.keeps = 0, next.kept = Item{};
    const ParticipantReaction rule = tables_.participant(static_cast<Role>(r), self.state, item.word);
    const auto* fault = std::get_if<ProtocolFault>(&rule);
    if (item.after_gap || fault != nullptr) {
      if (before.faults == 0)
        finding("fault without a cause", before,
                std::string(name(item.word)) + " came to the " + name(static_cast<Role>(r)));
      participant_fails(state, r);
      return;
    }
    const auto& rules = std::get<ParticipantStep>(rule);
    next.state = state_during(rules.action, self.state);
    if (rules.action == ParticipantAction::keep) {
      next.keeps = 1;
      next.kept = item;
    } else if (next.state != self.state) {
      next.before = self.state;
      next.command = item.word;
      next.command_revision = item.revision;
    } else {
      next.state = rules.outcomes[0].next;
    }
    if (next.state == ParticipantState::ended) next = ended(next);
    step(state);
  }
  static Participant ended(Participant participant) {
    participant.state = ParticipantState::ended;
    participant.alive = 0;
    return participant;
  }

  void participant_completes(const State& before, int r) {
    const Participant& self = before.participants[r];
    const bool at_work = self.state == ParticipantState::working || self.state == ParticipantState::joining;
    if (!self.alive || self.stalled || !at_work || !before.to_coupler[r].has_room()) return;
    const auto rules =
        std::get<ParticipantStep>(tables_.participant(static_cast<Role>(r), self.before, self.command));
    for (std::size_t i = 0; i < rules.outcome_count; ++i) {
      State state = before;
      Participant& next = state.participants[r];
      next.state = rules.outcomes[i].next;
      next.command = Word::hello;
      next.before = ParticipantState::greeting;
      next.command_revision = none;
      carry_out(before, rules.action, self, next, r);
      if (rules.outcomes[i].reply) state.to_coupler[r].push({*rules.outcomes[i].reply, next.revision});
      step(state);
    }
  }

  void carry_out(const State& before, ParticipantAction action, const Participant& self, Participant& next,
                 int r) {
    const bool structure = static_cast<Role>(r) == Role::structure;
    if (action == ParticipantAction::join && structure && !resumes(before)) next.revision = 0;
    if (action == ParticipantAction::insert) {
      const bool own_first = structure && self.command_revision == 0;
      if (!own_first && self.revision >= self.command_revision)
        finding("inserted twice", before, name(static_cast<Role>(r)));
      next.revision = self.command_revision;
    }
    if (action == ParticipantAction::restore) next.revision = self.command_revision;
    const bool uses_network = action == ParticipantAction::advance || action == ParticipantAction::save ||
                              action == ParticipantAction::report || action == ParticipantAction::finish;
    if (uses_network && self.revision != self.command_revision)
      finding("insertion lost", before, name(static_cast<Role>(r)));
  }

  void participant_notes(const State& before, int r) {
    const Participant& self = before.participants[r];
    if (!self.alive || self.stalled || self.state != ParticipantState::working ||
        before.to_coupler[r].size > 0)
      return;
    State state = before;
    state.to_coupler[r].push({Word::progress});
    reach(state);
  }

  void coupler_notes(const State& before, int r) {
    if (before.to_participant[r].size > 0) return;
    if (std::holds_alternative<ProtocolFault>(
            tables_.coupler_says(static_cast<Role>(r), before.views[r], Word::progress)))
      return;
    State state = before;
    state.to_participant[r].push({Word::progress});
    reach(state);
  }

  /// @returns whether the coupler's own table let it
  bool say(State& state, int r, Word word) {
    const CouplerMove move = tables_.coupler_says(static_cast<Role>(r), state.views[r], word);
    if (const auto* fault = std::get_if<ProtocolFault>(&move)) {
      finding("refused by the own table", state,
              std::string(name(word)) + " to the " + name(static_cast<Role>(r)) + ": " + name(*fault));
      return false;
    }
    state.views[r] = std::get<CouplerView>(move);
    state.answered[r] = 0;
    state.answers[r] = Word::hello;
    if (state.to_participant[r].has_room()) state.to_participant[r].push({word, state.revision});
    return true;
  }

  void coupler_hears(const State& before, int r) {
    if (before.to_coupler[r].size == 0) return;
    State state = before;
    const Item item = state.to_coupler[r].pop();
    const CouplerReaction rule = tables_.coupler_hears(static_cast<Role>(r), before.views[r], item.word);
    ++steps_;
    if (item.after_gap || std::holds_alternative<ProtocolFault>(rule)) {
      end_by_fault(before, std::string(name(item.word)) + " came from the " + name(static_cast<Role>(r)));
      return;
    }
    const auto& rules = std::get<CouplerStep>(rule);
    state.views[r] = rules.next;
    switch (rules.action) {
      case CouplerAction::greet:
        if (!say(state, r, resumes(state) ? Word::welcome_resuming : Word::welcome)) return;
        break;
      case CouplerAction::take:
        state.answered[r] = 1;
        state.answers[r] = item.word;
        break;
      case CouplerAction::release:
        if (!say(state, r, Word::bye)) return;
        state.answered[r] = 1;
        break;
      case CouplerAction::hear_failure:
        end_by_fault(before, "FAIL");
        return;
      case CouplerAction::note:
      case CouplerAction::ignore:
        break;
    }
    reach(state);
  }

  void coupler_sees_end(const State& state, int r) {
    if (state.participants[r].alive || state.views[r] == CouplerView::leaving) return;
    ++steps_;
    end_by_fault(state, std::string("the end of the ") + name(static_cast<Role>(r)));
  }

  // ---- the scheme -----------------------------------------------------------------------------------

  void ask(State state, Place place, std::initializer_list<std::pair<Role, Word>> commands) {
    state.place = place;
    for (const auto& [role, word] : commands)
      if (!say(state, static_cast<int>(role), word)) return;
    step(state);
  }
  void ask_both(const State& state, Place place, Word word) {
    ask(state, place, {{Role::structure, word}, {Role::network, word}});
  }

  void scheme(const State& state) {
    const bool both = state.answered[0] && state.answered[1];
    State next = state;
    switch (state.place) {
      case Place::greeting:
        if (state.views[0] == CouplerView::absent || state.views[1] == CouplerView::absent) return;
        if (!resumes(state)) {
          next.place = Place::first_topology;
          step(next);
          return;
        }
        next.revision = state.checkpoint_revision;
        next.interval = state.checkpoint_interval;
        ask_both(next, Place::restoring, Word::restore);
        return;
      case Place::first_topology:
        if (!state.answered[0]) return;
        next.revision = 0;
        ask_both(next, Place::first_insertion, Word::insert);
        return;
      case Place::restoring:
        if (both && (state.participants[0].revision != state.revision ||
                     state.participants[1].revision != state.revision))
          finding("resumed differently", state, "");
        [[fallthrough]];
      case Place::first_insertion:
        if (!both) return;
        next.place = Place::between;
        step(next);
        return;
      case Place::between:
        if (state.interval == options_.intervals) {
          ask_both(next, Place::finishing, Word::finish);
        } else {
          ++next.interval;
          ask(next, Place::network, {{Role::network, Word::advance}});
        }
        return;
      case Place::network:
        if (state.answered[1]) ask(next, Place::structure, {{Role::structure, Word::advance}});
        return;
      case Place::structure:
        if (!state.answered[0]) return;
        next.proposed = state.answers[0] == Word::proposal;
        next.place = Place::after_structure;
        ask_both(next, Place::reporting, Word::report);
        step(next);
        return;
      case Place::reporting:
        if (!both) return;
        next.place = Place::after_structure;
        step(next);
        return;
      case Place::after_structure:
        next.proposed = 0;
        if (state.proposed) {
          ++next.revision;
          ask_both(next, Place::inserting, Word::insert);
        } else {
          next.place = Place::accepted;
          step(next);
        }
        return;
      case Place::inserting:
        if (!both) return;
        next.place = Place::accepted;
        step(next);
        return;
      case Place::accepted:
        next.place = Place::between;
        step(next);
        ask_both(state, Place::saving, Word::save);
        return;
      case Place::saving:
        if (!both) return;
        next.checkpoint_revision = state.revision;
        next.checkpoint_interval = state.interval;
        next.place = Place::between;
        step(next);
        return;
      case Place::finishing:
        if (!both || state.participants[0].alive || state.participants[1].alive) return;
        next = State{};
        next.place = Place::complete;
        step(next);
        return;
      case Place::complete:
      case Place::failed:
        return;
    }
  }

  void insist(const State& before) {
    State state = before;
    for (int r = 0; r < 2; ++r)
      if (!state.answered[r] && !say(state, r, Word::insert)) return;
    reach(state);
  }

  // ---- faults ---------------------------------------------------------------------------------------

  void faults(const State& before) {
    State struck = before;
    ++struck.faults;
    end(struck);  // the coupler is killed: the supervisor ends the others
    for (int r = 0; r < 2; ++r) {
      const Participant& self = before.participants[r];
      if (self.alive) {
        State killed = struck;
        killed.participants[r] = ended(self);
        killed.to_participant[r] = Queue{};
        reach(killed);
        State stalled = struck;
        stalled.participants[r].stalled = 1;
        reach(stalled);
        if (self.state == ParticipantState::working || self.state == ParticipantState::joining)
          participant_fails(struck, r);
      }
      if (before.to_coupler[r].size > 0) {
        State lost = struck;
        lost.to_coupler[r].lose_last();
        reach(lost);
      }
      if (before.to_participant[r].size > 0) {
        State lost = struck;
        lost.to_participant[r].lose_last();
        reach(lost);
      }
    }
  }

  const ProtocolTables& tables_;
  ModelOptions options_;
  std::unordered_set<std::string> seen_;
  std::deque<const std::string*> waiting_;
  std::size_t steps_ = 0;
  Exploration found_;
};

}  // namespace

ProtocolTables real_tables() {
  return {[](Role role, ParticipantState state, Word word) { return reaction(role, state, word); },
          [](Role role, CouplerView view, Word word) { return reaction(role, view, word); },
          [](Role role, CouplerView view, Word word) { return move(role, view, word); }};
}

Exploration explore(const ProtocolTables& tables, const ModelOptions& options) {
  return Explorer(tables, options).run();
}

}  // namespace fissura::test
