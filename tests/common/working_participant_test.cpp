// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <thread>

#include "common/errors.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/participant.hpp"

using namespace fissura;

namespace {

/// A flow solver that needs long to set up, and says that it gets on.
class SlowSolver : public Solver {
 public:
  explicit SlowSolver(const std::atomic<bool>& go_on) : go_on_(go_on) {}
  void join(const Assignment&) override {
    while (go_on_) {
      note_progress("setup");
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  Message advance(const Message&) override { return Message(MessageType::pressure); }
  std::string insert(const Insertion&) override { return {}; }
  Message report(const Message&) override { return Message(MessageType::fields); }
  std::vector<std::byte> save() override { return {}; }
  std::optional<std::string> restore(const std::vector<std::byte>&) override { return {}; }

 private:
  const std::atomic<bool>& go_on_;
};

}  // namespace

TEST_CASE("a solver at work does not lose its coupler, however often that says that it lives",
          "[common][exchange]") {
  std::string folder = (std::filesystem::temp_directory_path() / "fissura-working-XXXXXX").string();
  REQUIRE(::mkdtemp(folder.data()) != nullptr);
  const std::string endpoint = "ipc://" + folder + "/socket";
  RunId run;
  run.fill(7);
  CouplerChannel coupler(endpoint, run, 0);
  std::atomic<bool> go_on = true;
  std::thread participant([&] {
    SlowSolver solver(go_on);
    run_participant(Role::network, {endpoint, "slow", "1", 60}, solver);
  });
  bool lost = false, welcomed = false;
  int words = 0;
  PeerNumber peer = 0;
  // More words than a queue holds, and then longer than the transport's heartbeat lasts.
  const auto end = std::chrono::steady_clock::now() + 3 * transport_silence;
  while (!lost && std::chrono::steady_clock::now() < end) {
    auto event = coupler.wait(Seconds(0.01), {});
    lost = std::holds_alternative<CouplerChannel::PeerLost>(event);
    if (const auto* received = std::get_if<CouplerChannel::Received>(&event);
        received != nullptr && !welcomed) {
      peer = received->peer;
      Message welcome(MessageType::welcome);
      welcome.body = {{"case", nlohmann::json::object()}, {"threads", 1}, {"coupler_deadline", 60.0}};
      coupler.send(peer, std::move(welcome));
      welcomed = true;
    }
    if (welcomed && words < 200) {
      try {
        coupler.send(peer, Message(MessageType::progress));
        ++words;
      } catch (const ProtocolError&) {
        lost = true;
      }
    }
  }
  CHECK(words == 200);
  CHECK_FALSE(lost);
  Message failure(MessageType::fail);
  failure.body = {{"reason", "the test is over"}};
  if (!lost) coupler.send(peer, std::move(failure));
  go_on = false;
  participant.join();
  std::filesystem::remove_all(folder);
}
