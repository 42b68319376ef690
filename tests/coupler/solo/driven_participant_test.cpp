// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/solo/driven_participant.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "common/exchange/codec.hpp"
#include "coupler/faults/forgery.hpp"
#include "tests/coupler/temporary_directory.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr Seconds patience{5};

RunId some_run() {
  RunId run;
  run.fill(9);
  return run;
}

/// A process that only waits, and this test speaking in its place on its socket.
class Impostor {
 public:
  Impostor()
      : driven_({.command = "/bin/sh -c 'echo $2 >\"" + (folder_.path() / "name").string() + "\"; mv \"" +
                            (folder_.path() / "name").string() + "\" \"" +
                            (folder_.path() / "endpoint").string() + "\"; exec sleep 20' sh",
                 .run = some_run(),
                 .epoch = 2}) {
    std::string endpoint;
    while (!std::getline(std::ifstream(folder_.path() / "endpoint"), endpoint))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    link_.emplace(FrameLink::connected(endpoint));
  }

  void say(Message message, const Stamp& stamp) {
    EncodedMessage encoded = encode(std::move(message), stamp);
    Frames frames;
    frames.emplace_back(encoded.envelope.begin(), encoded.envelope.end());
    const auto body = std::as_bytes(std::span(encoded.body));
    frames.emplace_back(body.begin(), body.end());
    for (auto& array : encoded.arrays) frames.push_back(std::move(array));
    REQUIRE(link_->send(frames));
  }
  void greet() {
    Message hello(MessageType::hello);
    hello.body = {{"role", "network"}};
    say(std::move(hello), {});
    REQUIRE(std::get<Message>(driven_.hear(patience)).type == MessageType::hello);
  }
  Frames hear() {
    for (;;)
      if (std::optional<Frames> frames = link_->receive()) return *frames;
  }

  DrivenParticipant& driven() { return driven_; }
  FrameLink& link() { return *link_; }

 private:
  sample::TemporaryDirectory folder_;
  DrivenParticipant driven_;
  std::optional<FrameLink> link_;
};

}  // namespace

TEST_CASE("driven participant: a program that ends is told of with how it ended, and with what it printed",
          "[coupler][solo]") {
  DrivenParticipant driven({.command = "/bin/sh -c 'echo sorry >&2; exit 7'"});
  const Heard heard = driven.hear(patience);
  REQUIRE(std::holds_alternative<ProcessEnd>(heard));
  CHECK(std::get<ProcessEnd>(heard).exit_code == 7);
  CHECK(driven.printed() == "sorry\n");
}

TEST_CASE("driven participant: silence is a value", "[coupler][solo]") {
  DrivenParticipant driven({.command = "/bin/sh -c 'exec sleep 20'"});
  CHECK(std::holds_alternative<Silence>(driven.hear(Seconds(0.05))));
  CHECK_FALSE(driven.wait_for_end(Seconds(0)));
  driven.send_signal(SIGTERM);
  const std::optional<ProcessEnd> end = driven.wait_for_end(patience);
  REQUIRE(end);
  CHECK(end->signal == SIGTERM);
}

TEST_CASE("driven participant: messages carry run, epoch and the next number in both directions",
          "[coupler][solo]") {
  Impostor impostor;
  impostor.greet();
  REQUIRE(impostor.driven().say(Message(MessageType::welcome)));
  Message save(MessageType::save);
  save.interval = 5;
  REQUIRE(impostor.driven().say(std::move(save)));
  const Frames first = impostor.hear(), second = impostor.hear();
  const std::vector<std::span<const std::byte>> views(second.begin(), second.end());
  const DecodedMessage decoded = decode(views);
  CHECK(decoded.message.type == MessageType::save);
  CHECK(decoded.message.interval == 5);
  CHECK(decoded.stamp.run == some_run());
  CHECK(decoded.stamp.epoch == 2);
  CHECK(decoded.stamp.sequence == 1);
  impostor.say(Message(MessageType::state), {some_run(), 2, 1});
  CHECK(std::get<Message>(impostor.driven().hear(patience)).type == MessageType::state);
  CHECK(impostor.driven().last_stamp().sequence == 1);
}

TEST_CASE("driven participant: what cannot be accepted is nonsense with a reason", "[coupler][solo]") {
  const auto heard_after = [](const Stamp& stamp) {
    Impostor impostor;
    impostor.greet();
    impostor.say(Message(MessageType::state), stamp);
    return in_words(impostor.driven().hear(patience));
  };
  CHECK_THAT(heard_after({some_run(), 2, 2}), Catch::Contains("lost"));
  CHECK_THAT(heard_after({some_run(), 2, 0}), Catch::Contains("twice"));
  CHECK_THAT(heard_after({some_run(), 1, 1}), Catch::Contains("epoch"));
  CHECK_THAT(heard_after({RunId{}, 2, 1}), Catch::Contains("another run"));
  Impostor impostor;
  impostor.greet();
  REQUIRE(impostor.link().send(nonsense(50)));
  CHECK(std::holds_alternative<Nonsense>(impostor.driven().hear(patience)));
}

TEST_CASE("driven participant: PROGRESS is kept and ends no wait, FAIL is a value", "[coupler][solo]") {
  Impostor impostor;
  impostor.greet();
  Message progress(MessageType::progress);
  progress.body = {{"phase", "newton"}, {"count", 3}, {"stop_signal", 15}};
  impostor.say(std::move(progress), {some_run(), 2, 1});
  Message failure(MessageType::fail);
  failure.body = {{"reason", "no more"}, {"exit_code", 24}};
  impostor.say(std::move(failure), {some_run(), 2, 2});
  const Heard heard = impostor.driven().hear(patience);
  REQUIRE(std::holds_alternative<ToldFailure>(heard));
  CHECK(std::get<ToldFailure>(heard).exit_code() == 24);
  CHECK(std::get<ToldFailure>(heard).reason() == "no more");
  REQUIRE(impostor.driven().progress().size() == 1);
  CHECK(impostor.driven().progress().front().phase == "newton");
  CHECK(impostor.driven().progress().front().stop_signal == 15);
}

TEST_CASE("driven participant: a connection that ends while the process stays is told of",
          "[coupler][solo]") {
  Impostor impostor;
  impostor.greet();
  impostor.link().cut();
  CHECK(std::holds_alternative<ConnectionLost>(impostor.driven().hear(patience)));
}
