// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "common/errors.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "tests/common/lone_participant.hpp"

using namespace fissura;
using test::LoneParticipant;

namespace {

Insertion first_node() {
  Insertion insertion;
  insertion.new_nodes = {{.id = 1, .lumped_length = 1}};
  return insertion;
}

Insertion second_node() {
  Insertion insertion;
  insertion.revision = 1;
  insertion.new_nodes = {{.id = 2, .x = 1, .lumped_length = 1}};
  return insertion;
}

/// A structure of which nothing is history but the number of intervals it has seen; it grows in the first
/// one.
class CountingStructure : public Solver {
 public:
  void join(const Assignment& assignment) override {
    resumes = assignment.resumes;
    const auto end = std::chrono::steady_clock::now() + time_to_join;
    while (std::chrono::steady_clock::now() < end) {
      note_progress("mesh");
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  Insertion first_topology() override {
    network.apply(first_node());
    return first_node();
  }
  void describe_state(Message& reply) override { reply.body["intervals"] = intervals_; }
  Message advance(const Message&) override {
    Message answer;
    if (++intervals_ == 1) answer.body["insertion"] = insertion_to_json(second_node());
    return answer;
  }
  std::string insert(const Insertion& insertion) override {
    network.apply(insertion);
    return network.topology_hash();
  }
  Message report(const Message&) override { return {}; }
  std::vector<std::byte> save() override { return {static_cast<std::byte>(intervals_)}; }
  std::optional<std::string> restore(const std::vector<std::byte>& state) override {
    intervals_ = std::to_integer<int>(state.at(0));
    return std::nullopt;
  }

  bool resumes = false;
  std::chrono::milliseconds time_to_join{0};
  FractureNetwork network;

 private:
  int intervals_ = 0;
};

Message command(MessageType type, std::uint64_t interval, std::uint64_t revision) {
  Message message(type);
  message.interval = interval;
  message.revision = revision;
  return message;
}

Message insert(const Insertion& insertion) {
  Message message = command(MessageType::insert, 1, insertion.revision);
  message.body["insertion"] = insertion_to_json(insertion);
  return message;
}

Message restore(const std::vector<Insertion>& insertions, const std::vector<std::byte>& state) {
  Message message = command(MessageType::restore, 1, insertions.size() - 1);
  message.body["insertions"] = nlohmann::json::array();
  for (const Insertion& insertion : insertions)
    message.body["insertions"].push_back(insertion_to_json(insertion));
  message.add_bytes("state", state);
  return message;
}

/// A structure at the end of interval 1, its proposal not carried out.
void reach_the_proposal(LoneParticipant& participant) {
  participant.welcome(false);
  CHECK(participant.receive().type == MessageType::topology);
  CHECK(participant.request(insert(first_node())).type == MessageType::acknowledge);
  CHECK(participant.request(command(MessageType::advance, 1, 0)).body.contains("insertion"));
}

}  // namespace

TEST_CASE("a participant that resumes has the network and the state of the one that was saved",
          "[common][exchange]") {
  std::vector<std::byte> state;
  std::string hash;
  {
    CountingStructure structure;
    LoneParticipant participant(Role::structure, structure);
    reach_the_proposal(participant);
    hash = participant.request(insert(second_node())).value<std::string>("hash");
    state = participant.request(command(MessageType::save, 1, 1)).bytes("state");
    CHECK_FALSE(structure.resumes);
  }
  CountingStructure structure;
  LoneParticipant participant(Role::structure, structure, 1);
  participant.welcome(true);
  const Message restored = participant.request(restore({first_node(), second_node()}, state));
  REQUIRE(restored.type == MessageType::restored);
  CHECK(structure.resumes);
  CHECK(restored.value<std::string>("hash") == hash);
  CHECK(restored.value<int>("intervals") == 1);
  CHECK(restored.revision == 1);
  CHECK(participant.request(command(MessageType::advance, 2, 1)).type == MessageType::response);
}

TEST_CASE("a first command that comes while the solver joins is carried out then", "[common][exchange]") {
  CountingStructure structure;
  structure.time_to_join = std::chrono::milliseconds(300);
  LoneParticipant participant(Role::structure, structure, 1);
  participant.welcome(true);
  CHECK(participant.request(restore({first_node()}, {std::byte{3}})).value<int>("intervals") == 3);
}

TEST_CASE("a state is not saved between a proposal and its insertion", "[common][exchange]") {
  CountingStructure structure;
  LoneParticipant participant(Role::structure, structure);
  reach_the_proposal(participant);
  const Message failure = participant.request(command(MessageType::save, 1, 0));
  CHECK(failure.type == MessageType::fail);
  CHECK(failure.value<int>("exit_code") == static_cast<int>(ExitCode::protocol_violation));
}

TEST_CASE("a participant at work is not restored", "[common][exchange]") {
  CountingStructure structure;
  LoneParticipant participant(Role::structure, structure);
  reach_the_proposal(participant);
  CHECK(participant.request(restore({first_node()}, {std::byte{0}})).type == MessageType::fail);
}
