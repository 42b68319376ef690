// SPDX-License-Identifier: GPL-3.0-or-later
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "common/errors.hpp"
#include "common/exchange/channel.hpp"

using namespace fissura;

namespace {

RunId some_run() {
  RunId run;
  run.fill(7);
  return run;
}

/// A coupler on loopback and keys for everybody.
struct Guarded {
  KeyPair coupler = new_key_pair(), structure = new_key_pair(), network = new_key_pair();
  CouplerChannel channel{
      {.endpoint = "tcp://127.0.0.1:*",
       .keys = CouplerKeys{coupler, {{"structure", structure.public_key}, {"network", network.public_key}}}},
      some_run(),
      0};
};

CouplerChannel::Event next_event(CouplerChannel& channel, Seconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  CouplerChannel::Event event = Silence{};
  while (
      (std::holds_alternative<Silence>(event) || std::holds_alternative<CouplerChannel::PeerLost>(event)) &&
      std::chrono::steady_clock::now() < end)
    event = channel.wait(Seconds(0.05), {});
  return event;
}

ExitCode refusal_of(ParticipantChannel& participant) {
  try {
    for (int attempt = 0; attempt < 40; ++attempt)
      if (std::holds_alternative<ConnectionLost>(participant.receive(Seconds(0.05))))
        return ExitCode::participant_died;
  } catch (const Error& error) {
    return error.code();
  }
  return ExitCode::done;
}

void check_nothing_comes(CouplerChannel& channel) {
  CHECK(std::holds_alternative<Silence>(next_event(channel, Seconds(0.3))));
}

int plain_connection(const std::string& endpoint) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(endpoint.substr(endpoint.rfind(':') + 1))));
  ::inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  const int descriptor = ::socket(AF_INET, SOCK_STREAM, 0);
  REQUIRE(::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0);
  return descriptor;
}

/// Whether the other end closes within `patience` seconds.
bool is_closed(int descriptor, int patience) {
  timeval limit{patience, 0};
  ::setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
  char byte = 0;
  for (;;) {
    const ssize_t count = ::recv(descriptor, &byte, 1, 0);
    if (count == 0) return true;
    if (count < 0) return errno == ECONNRESET;
  }
}

}  // namespace

TEST_CASE("the coupler knows by the key which role a connection may claim", "[common][security]") {
  Guarded coupler;
  for (const auto& [pair, role] : {std::pair{coupler.structure, "structure"}, {coupler.network, "network"}}) {
    ParticipantChannel participant(coupler.channel.endpoint(),
                                   ParticipantKeys{pair, coupler.coupler.public_key}, Seconds(2));
    participant.send(Message(MessageType::hello));
    const auto event = next_event(coupler.channel, Seconds(2));
    const auto* received = std::get_if<CouplerChannel::Received>(&event);
    REQUIRE(received != nullptr);
    CHECK(received->proven_role == role);
    coupler.channel.send(received->peer, Message(MessageType::welcome));
    CHECK(std::holds_alternative<Message>(participant.receive(Seconds(2))));
  }
}

TEST_CASE("nothing is heard of a participant without the right keys, and it learns why",
          "[common][security]") {
  Guarded coupler;
  std::optional<ParticipantKeys> keys;
  SECTION("without keys") {}
  SECTION("a key that nobody allowed") {
    keys = ParticipantKeys{new_key_pair(), coupler.coupler.public_key};
  }
  SECTION("for another coupler") {
    keys = ParticipantKeys{coupler.structure, new_key_pair().public_key};
  }
  ParticipantChannel participant(coupler.channel.endpoint(), keys, Seconds(2));
  // The refusal may come while the greeting is sent, or later.
  ExitCode refusal = ExitCode::done;
  try {
    participant.send(Message(MessageType::hello));
  } catch (const Error& error) {
    refusal = error.code();
  }
  check_nothing_comes(coupler.channel);
  if (refusal == ExitCode::done) refusal = refusal_of(participant);
  CHECK(refusal == ExitCode::security);
}

TEST_CASE("a participant with keys does not talk to a coupler without", "[common][security]") {
  CouplerChannel channel("tcp://127.0.0.1:*", some_run(), 0);
  ParticipantChannel participant(channel.endpoint(),
                                 ParticipantKeys{new_key_pair(), new_key_pair().public_key}, Seconds(2));
  check_nothing_comes(channel);
  CHECK(refusal_of(participant) == ExitCode::security);
}

TEST_CASE("who does not begin with HELLO is cut off unheard", "[common][security]") {
  CouplerChannel channel("tcp://127.0.0.1:*", some_run(), 0);
  ParticipantChannel stranger(channel.endpoint());
  stranger.adopt_run(some_run(), 0);
  stranger.send(Message(MessageType::pressure));
  check_nothing_comes(channel);
  CHECK(refusal_of(stranger) == ExitCode::participant_died);
}

TEST_CASE("strangers that say nothing are closed, the oldest first, and make room for a participant",
          "[common][security]") {
  CouplerChannel channel(Listening{.endpoint = "tcp://127.0.0.1:*", .most_connections = 4}, some_run(), 0);
  std::vector<int> strangers;
  for (int i = 0; i < 12; ++i) strangers.push_back(plain_connection(channel.endpoint()));
  for (int i = 0; i < 8; ++i) CHECK(is_closed(strangers[static_cast<std::size_t>(i)], 1));
  ParticipantChannel participant(channel.endpoint());
  participant.send(Message(MessageType::hello));
  CHECK(std::holds_alternative<CouplerChannel::Received>(next_event(channel, Seconds(1))));
  for (const int descriptor : strangers) ::close(descriptor);
}

TEST_CASE("a participant's own connection survives any number of strangers", "[common][security]") {
  CouplerChannel channel(Listening{.endpoint = "tcp://127.0.0.1:*", .most_connections = 4}, some_run(), 0);
  ParticipantChannel participant(channel.endpoint());
  participant.send(Message(MessageType::hello));
  const auto event = next_event(channel, Seconds(1));
  const PeerNumber peer = std::get<CouplerChannel::Received>(event).peer;
  channel.send(peer, Message(MessageType::welcome));
  std::vector<int> strangers;
  for (int i = 0; i < 40; ++i) strangers.push_back(plain_connection(channel.endpoint()));
  check_nothing_comes(channel);
  CHECK(std::holds_alternative<Message>(participant.receive(Seconds(1))));
  for (const int descriptor : strangers) ::close(descriptor);
}

TEST_CASE("a frame above the bound is told as such", "[common][security]") {
  CouplerChannel channel(Listening{.endpoint = "tcp://127.0.0.1:*", .largest_frame = 1 << 20}, some_run(), 0);
  ParticipantChannel participant(channel.endpoint());
  participant.send(Message(MessageType::hello));
  const auto event = next_event(channel, Seconds(1));
  channel.send(std::get<CouplerChannel::Received>(event).peer, Message(MessageType::welcome));
  REQUIRE(std::holds_alternative<Message>(participant.receive(Seconds(1))));
  Message large(MessageType::pressure);
  large.add("pressure", "Pa", std::vector<double>(1 << 18, 1.0));
  participant.send(std::move(large));
  std::optional<Loss> how;
  for (int attempt = 0; attempt < 40 && !how; ++attempt)
    if (const auto loss = channel.wait(Seconds(0.05), {});
        const auto* lost = std::get_if<CouplerChannel::PeerLost>(&loss))
      how = lost->how;
  CHECK(how == Loss::broke_framing);
}

TEST_CASE("a participant waits for a coupler that is not there yet, and gives up in time",
          "[common][security]") {
  CHECK_THROWS_AS(ParticipantChannel("ipc:///tmp/fissura-nobody-listens-here", std::nullopt, Seconds(0.3)),
                  Error);
}
