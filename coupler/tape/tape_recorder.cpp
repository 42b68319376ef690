// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/tape_recorder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "common/errors.hpp"
#include "common/exchange/envelope.hpp"

namespace fissura::coupler {

namespace {

/// Type of a message of which nothing has been checked.
std::optional<MessageType> type_of(FrameViews frames) {
  try {
    if (!frames.empty()) return decode_envelope(frames[0]).type;
  } catch (const ProtocolError&) {
  }
  return std::nullopt;
}

std::optional<Role> claimed_role(const Frames& hello) {
  if (hello.size() < 2) return std::nullopt;
  const auto* text = reinterpret_cast<const char*>(hello[1].data());
  const auto body = nlohmann::json::parse(text, text + hello[1].size(), nullptr, false);
  for (const Role role : {Role::structure, Role::network})
    if (body.is_object() && body.value("role", nlohmann::json()) == name(role)) return role;
  return std::nullopt;
}

}  // namespace

TapeRecorder::TapeRecorder(const std::filesystem::path& run_directory, std::set<Role> roles, const RunId& run,
                           std::uint32_t epoch)
    : run_directory_(run_directory),
      roles_(std::move(roles)),
      run_(run),
      epoch_(epoch),
      started_utc_(
          std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count()) {
  if (roles_.empty()) return;
  std::error_code failure;
  std::filesystem::create_directory(run_directory / tape_folder_name, failure);
  if (failure)
    throw StorageError(
        fmt::format("cannot create {}: {}", (run_directory / tape_folder_name).string(), failure.message()));
}

double TapeRecorder::now() const {
  return std::chrono::duration<double>(Clock::now() - started_).count();
}

void TapeRecorder::sent(PeerNumber peer, FrameViews frames) {
  if (greeting_ && greeting_->peer == peer) {
    if (type_of(frames) == MessageType::welcome) begin_tape(peer, *greeting_);
    greeting_.reset();
  }
  if (const auto tape = tapes_.find(peer); tape != tapes_.end())
    tape->second.write(Direction::to_participant, now(), frames);
}

void TapeRecorder::received(PeerNumber peer, FrameViews frames) {
  if (const auto tape = tapes_.find(peer); tape != tapes_.end()) {
    tape->second.write(Direction::to_coupler, now(), frames);
  } else if (type_of(frames) == MessageType::hello) {
    greeting_ = Greeting{peer, now(), {}};
    for (const auto& frame : frames) greeting_->frames.emplace_back(frame.begin(), frame.end());
  }
}

void TapeRecorder::begin_tape(PeerNumber peer, const Greeting& greeting) {
  const std::optional<Role> role = claimed_role(greeting.frames);
  if (!role || !roles_.contains(*role)) return;
  const TapeHeader header{*role, epoch_, run_, started_utc_};
  const auto tape = tapes_.emplace(peer, TapeWriter(tape_file(run_directory_, *role, epoch_), header)).first;
  const std::vector<std::span<const std::byte>> views(greeting.frames.begin(), greeting.frames.end());
  tape->second.write(Direction::to_coupler, greeting.time, views);
}

void TapeRecorder::sync() {
  for (auto& [peer, tape] : tapes_) tape.sync();
}

}  // namespace fissura::coupler
