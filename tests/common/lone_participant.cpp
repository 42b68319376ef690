// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/common/lone_participant.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>

namespace fissura::test {

namespace {

RunId some_run() {
  RunId run;
  run.fill(7);
  return run;
}

}  // namespace

LoneParticipant::LoneParticipant(Role role, Solver& solver, std::uint32_t epoch)
    : coupler_("ipc://" + (folder_ / "socket").string(), some_run(), epoch),
      participant_([this, role, &solver] {
        code_ = run_participant(role, {coupler_.endpoint(), "lone", "1", 60}, solver);
      }) {
  hello_ = receive();
}

LoneParticipant::~LoneParticipant() {
  if (participant_.joinable()) {
    Message failure(MessageType::fail);
    failure.body = {{"reason", "the test is over"}};
    try {
      send(std::move(failure));
    } catch (const Error&) {
      // It has ended already.
    }
    participant_.join();
  }
  std::filesystem::remove_all(folder_);
}

void LoneParticipant::send(Message command) {
  coupler_.send(peer_, std::move(command));
}

Message LoneParticipant::receive() {
  for (int attempt = 0; attempt < 100; ++attempt) {
    CouplerChannel::Event event = coupler_.wait(Seconds(0.1), {});
    auto* received = std::get_if<CouplerChannel::Received>(&event);
    if (received == nullptr || received->message.type == MessageType::progress) continue;
    peer_ = received->peer;
    return std::move(received->message);
  }
  throw std::runtime_error("nothing came");
}

Message LoneParticipant::request(Message command) {
  send(std::move(command));
  return receive();
}

void LoneParticipant::welcome(bool resumes) {
  Message message(MessageType::welcome);
  message.body = {
      {"case", nlohmann::json::object()}, {"threads", 1}, {"coupler_deadline", 60.0}, {"resumes", resumes}};
  send(std::move(message));
}

int LoneParticipant::end() {
  participant_.join();
  return code_;
}

std::filesystem::path LoneParticipant::new_folder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "fissura-participant-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return pattern;
}

}  // namespace fissura::test
