// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>

#include "common/exchange/protocol_table.hpp"

/// A model of the trio that follows the tables of protocol_table.hpp: the coupler's scheme (topology,
/// intervals, reports, insertions, checkpoints, the end), both participants, a queue in each direction, and
/// one fault at any moment: a process is killed, a solver fails, a participant stalls, a message is lost.
/// After a fault the run takes up its checkpoint once.
namespace fissura::test {

/// What the model looks up; a test may change an entry.
struct ProtocolTables {
  std::function<ParticipantReaction(Role, ParticipantState, Word)> participant;
  std::function<CouplerReaction(Role, CouplerView, Word)> coupler_hears;
  std::function<CouplerMove(Role, CouplerView, Word)> coupler_says;
};

/// Those that the programs follow.
ProtocolTables real_tables();

struct ModelOptions {
  int intervals = 2;     ///< of the run
  int faults = 1;        ///< at most so many
  int lives = 2;         ///< of the run
  bool insists = false;  ///< a coupler that repeats an INSERT which is not acknowledged instead of giving up
};

/// What a model has found.
struct Exploration {
  std::size_t states = 0;
  std::size_t complete = 0;  ///< states in which the run is complete
  std::size_t failed = 0;    ///< states in which it has ended with a fault told
  /// First example of each kind: "deadlock", "fault without a cause", "refused by the own table", "inserted
  /// twice", "insertion lost", "resumed differently".
  std::map<std::string, std::string> findings;
};

/// Every state that can be reached, breadth first.
Exploration explore(const ProtocolTables& tables, const ModelOptions& options);

}  // namespace fissura::test
