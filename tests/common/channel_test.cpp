// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "common/errors.hpp"
#include "common/exchange/channel.hpp"

using namespace fissura;

namespace {

constexpr Seconds patience{2.0};

/// A socket path of this test's own, gone with it.
class SocketFile {
 public:
  SocketFile() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fissura-channel-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    folder_ = pattern;
  }
  ~SocketFile() { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string endpoint() const { return "ipc://" + (folder_ / "socket").string(); }

 private:
  std::filesystem::path folder_;
};

RunId some_run() {
  RunId run;
  run.fill(7);
  return run;
}

template <typename T>
T wait_for(CouplerChannel& coupler) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    CouplerChannel::Event event = coupler.wait(Seconds(0.1), {});
    if (T* wanted = std::get_if<T>(&event)) return std::move(*wanted);
    REQUIRE(std::holds_alternative<Silence>(event));
  }
  FAIL("nothing came");
  throw;
}

Message welcome() { return Message(MessageType::welcome); }

}  // namespace

TEST_CASE("messages go both ways over a real socket", "[common][exchange]") {
  const SocketFile file;
  CouplerChannel coupler(file.endpoint(), some_run(), 0);
  ParticipantChannel participant(file.endpoint());
  participant.send(Message(MessageType::hello));
  const auto hello = wait_for<CouplerChannel::Received>(coupler);
  CHECK(hello.message.type == MessageType::hello);
  coupler.send(hello.peer, welcome());
  auto answer = participant.receive(patience);
  REQUIRE(std::holds_alternative<Message>(answer));
  Message pressure(MessageType::pressure);
  pressure.add("pressure", "Pa", std::vector<double>(1000, 3.0));
  participant.send(std::move(pressure));
  CHECK(wait_for<CouplerChannel::Received>(coupler).message.numbers("pressure", 1000)[999] == 3.0);
}

TEST_CASE("a wait ends when its time is over", "[common][exchange]") {
  const SocketFile file;
  CouplerChannel coupler(file.endpoint(), some_run(), 0);
  CHECK(std::holds_alternative<Silence>(coupler.wait(Seconds(0.01), {})));
  ParticipantChannel participant(file.endpoint());
  CHECK(std::holds_alternative<Silence>(participant.receive(Seconds(0.01))));
}

TEST_CASE("a participant learns that the coupler is gone", "[common][exchange]") {
  const SocketFile file;
  auto coupler = std::make_unique<CouplerChannel>(file.endpoint(), some_run(), 0);
  ParticipantChannel participant(file.endpoint());
  participant.send(Message(MessageType::hello));
  coupler->send(wait_for<CouplerChannel::Received>(*coupler).peer, welcome());
  CHECK(std::holds_alternative<Message>(participant.receive(patience)));
  coupler.reset();
  CHECK(std::holds_alternative<ConnectionLost>(participant.receive(patience)));
}

TEST_CASE("the coupler hears the last words of a participant, then learns that it is gone", "[common][exchange]") {
  const SocketFile file;
  CouplerChannel coupler(file.endpoint(), some_run(), 0);
  auto participant = std::make_unique<ParticipantChannel>(file.endpoint());
  participant->send(Message(MessageType::hello));
  const PeerNumber peer = wait_for<CouplerChannel::Received>(coupler).peer;
  participant->adopt_run(some_run(), 0);
  participant->send(Message(MessageType::fail));
  participant.reset();
  CHECK(wait_for<CouplerChannel::Received>(coupler).message.type == MessageType::fail);
  CHECK(wait_for<CouplerChannel::PeerLost>(coupler).peer == peer);
}

TEST_CASE("a message of another run is refused", "[common][exchange]") {
  const SocketFile file;
  CouplerChannel coupler(file.endpoint(), some_run(), 0);
  ParticipantChannel participant(file.endpoint());
  participant.send(Message(MessageType::hello));
  (void)wait_for<CouplerChannel::Received>(coupler);
  RunId other;
  other.fill(9);
  participant.adopt_run(other, 0);
  participant.send(Message(MessageType::pressure));
  CHECK_THAT(wait_for<CouplerChannel::PeerFault>(coupler).reason, Catch::Contains("belongs to another run"));
}

TEST_CASE("a participant that fails over its WELCOME is heard, though it does not know its run", "[common][exchange]") {
  const SocketFile file;
  CouplerChannel coupler(file.endpoint(), some_run(), 3);
  ParticipantChannel participant(file.endpoint());
  participant.send(Message(MessageType::hello));
  (void)wait_for<CouplerChannel::Received>(coupler);
  participant.send(Message(MessageType::fail));
  CHECK(wait_for<CouplerChannel::Received>(coupler).message.type == MessageType::fail);
  participant.send(Message(MessageType::pressure));
  CHECK_THAT(wait_for<CouplerChannel::PeerFault>(coupler).reason, Catch::Contains("belongs to another run"));
}

TEST_CASE("a message from before a resume is refused", "[common][exchange]") {
  const SocketFile file;
  CouplerChannel coupler(file.endpoint(), some_run(), 3);
  ParticipantChannel participant(file.endpoint());
  participant.send(Message(MessageType::hello));
  (void)wait_for<CouplerChannel::Received>(coupler);
  participant.adopt_run(some_run(), 2);
  participant.send(Message(MessageType::pressure));
  CHECK_THAT(wait_for<CouplerChannel::PeerFault>(coupler).reason, Catch::Contains("epoch 2, this is epoch 3"));
}

TEST_CASE("two couplers cannot share a TCP endpoint", "[common][exchange]") {
  CouplerChannel first("tcp://127.0.0.1:*", some_run(), 0);
  try {
    CouplerChannel second(first.endpoint(), some_run(), 0);
    FAIL("the second coupler was given the endpoint too");
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::role_taken);
  }
}
