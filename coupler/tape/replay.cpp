// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "common/exchange/codec.hpp"
#include "coupler/launch/process_activity.hpp"
#include "coupler/launch/process_tree.hpp"
#include "coupler/solo/driven_participant.hpp"
#include "coupler/tape/message_difference.hpp"
#include "coupler/tape/network_places.hpp"
#include "coupler/tape/tape_reader.hpp"

namespace fissura::coupler {

namespace {

using Clock = std::chrono::steady_clock;

constexpr Seconds patience_for_hello{60};
constexpr Seconds endless{1e9};
constexpr Seconds between_looks{0.1};
constexpr Seconds farewell{5};  // until the process ends after its BYE is returned

Message decoded(const Frames& frames) {
  const std::vector<std::span<const std::byte>> views(frames.begin(), frames.end());
  return decode(views).message;
}

std::string solver_of(const Frames& hello) {
  const Message message = decoded(hello);
  return fmt::format("{} {}", message.body.value("solver", ""), message.body.value("version", ""));
}

bool expects_an_answer(MessageType command, Role role) {
  switch (command) {
    case MessageType::welcome:
      return role == Role::structure;
    case MessageType::insert:
    case MessageType::advance:
    case MessageType::report:
    case MessageType::save:
    case MessageType::restore:
    case MessageType::finish:
      return true;
    default:
      return false;
  }
}

ExitCode code_of(const Heard& heard) {
  if (std::holds_alternative<Nonsense>(heard)) return ExitCode::protocol_violation;
  if (std::holds_alternative<Silence>(heard)) return ExitCode::participant_unresponsive;
  return ExitCode::participant_died;
}

bool is_message(const Heard& heard) {
  return std::holds_alternative<Message>(heard) || std::holds_alternative<ToldFailure>(heard);
}

class Replay {
 public:
  explicit Replay(const ReplayOptions& options)
      : options_(options),
        tape_(options.tape),
        participant_({.command = options.command,
                      .run = tape_.header().run,
                      .epoch = tape_.header().epoch,
                      .printed = Printed::shown}) {}

  ReplayResult run() {
    while (std::optional<TapeRecord> record = tape_.next()) {
      if (record->damaged)
        throw StorageError(fmt::format("{}: message {} at byte {} is not what was written",
                                       tape_.file().string(), record->number, record->offset));
      const Envelope envelope = envelope_of(record->frames);
      if (envelope.type == MessageType::progress) continue;
      if (options_.until && envelope.interval > *options_.until) return ended();
      const bool goes_on = record->direction == Direction::to_participant ? say(std::move(*record), envelope)
                                                                          : compare(*record, envelope);
      if (!goes_on) return ended();
    }
    if (unanswered_) see_what_becomes_of_it();
    if (tape_.cut_bytes() > 0) result_.finding += "  the tape ends in the middle of a message\n";
    return ended();
  }

 private:
  bool say(TapeRecord&& record, const Envelope& envelope) {
    const std::string title = title_of(record.frames);
    if (envelope.type == MessageType::welcome) take_deadlines(record.frames);
    places_.follow(record.frames);
    unanswered_ = expects_an_answer(envelope.type, tape_.header().role) ? std::optional(title) : std::nullopt;
    said_live_ = record.time;
    said_ = Clock::now();
    const bool patient = envelope.type == MessageType::welcome && options_.patience == Patience::endless;
    if (!(patient ? participant_.say(patient_welcome(record.frames))
                  : participant_.say_again(std::move(record.frames)))) {
      const Heard last = participant_.hear(Seconds(0));
      fail("nobody could be told " + title, last);
      return false;
    }
    ++result_.said;
    released_ = envelope.type == MessageType::bye;
    return true;
  }

  bool compare(const TapeRecord& record, const Envelope& envelope) {
    const bool introduction = result_.identical == 0;
    const Heard heard = hear(introduction ? patience_for_hello : patience_);
    if (!is_message(heard)) {
      fail(fmt::format("the tape has {}", title_of(record.frames)), heard);
      return false;
    }
    const Clock::time_point now = Clock::now();
    const Frames& answer = participant_.last_frames();
    if (const auto found = difference(record.frames, answer)) {
      result_.code = ExitCode::verdict_failed;
      result_.finding =
          fmt::format("{}, message {} of the tape, differs:\n", title_of(record.frames), record.number) +
          in_words(*found, places_.place(record.frames, found->array, found->row),
                   {.first = "tape", .second = "replay"});
      if (const auto* failure = std::get_if<ToldFailure>(&heard))
        result_.finding += fmt::format("    it says: {}\n", failure->reason());
      return false;
    }
    if (introduction) introduce(record, now);
    ++result_.identical;
    result_.interval = std::max(result_.interval, envelope.interval);
    result_.live_seconds = record.time - begin_live_;
    result_.seconds = Seconds(now - begin_).count();
    if (unanswered_) {
      result_.live_answering += record.time - said_live_;
      result_.answering += Seconds(now - said_).count();
    }
    unanswered_.reset();
    return true;
  }

  void introduce(const TapeRecord& hello, Clock::time_point now) {
    result_.taped_solver = solver_of(hello.frames);
    result_.solver = solver_of(participant_.last_frames());
    begin_live_ = hello.time;
    begin_ = now;
    pid_ = static_cast<pid_t>(decoded(participant_.last_frames()).body.value("pid", 0L));
    started_by_debugger_ = tracer_of(pid_) == participant_.pid();
    if (!options_.on_hello) return;
    options_.on_hello(pid_);
    begin_ = Clock::now();
  }

  /// A participant that gets on has all the time it needs.
  Heard hear(Seconds patience) {
    if (options_.patience == Patience::endless) patience = endless;
    for (;;) {
      const std::size_t signs = participant_.progress().size();
      Heard heard = participant_.hear(patience);
      if (!std::holds_alternative<Silence>(heard) || participant_.progress().size() == signs) return heard;
    }
  }

  /// As the run had them: for joining the longer one, so that one is enough.
  void take_deadlines(const Frames& welcome) {
    const Message message = decoded(welcome);
    const auto& run_case = message.body.value("case", nlohmann::json::object());
    const auto deadlines = run_case.find("deadlines");
    if (deadlines == run_case.end() || !deadlines->is_object()) return;
    patience_ = Seconds(std::max(deadlines->value("join", 0.0), deadlines->value("progress", 0.0)));
  }

  static Message patient_welcome(const Frames& welcome) {
    Message message = decoded(welcome);
    message.body["coupler_deadline"] = endless.count();
    message.body.erase("arrays");
    return message;
  }

  void see_what_becomes_of_it() {
    const Heard heard = hear(patience_);
    result_.finding += fmt::format("  the tape ends with {}, which was not answered; here came {}\n",
                                   *unanswered_, in_words(heard));
    if (!is_message(heard)) result_.code = code_of(heard);
  }

  void fail(const std::string& situation, const Heard& heard) {
    result_.code = code_of(heard);
    result_.finding = fmt::format("{}, but here came {}\n", situation, in_words(heard));
  }

  /// A participant that was let go ends by itself; any other is in the middle of a run.
  ReplayResult ended() {
    if (options_.on_end) options_.on_end(result_);
    if (options_.patience == Patience::endless)
      while ((started_by_debugger_ || tracer_of(pid_)) && !participant_.wait_for_end(between_looks)) {
      }
    if (result_.code == ExitCode::done && !options_.until)
      participant_.wait_for_end(released_ ? farewell : Seconds(0));
    participant_.send_signal(SIGKILL);
    return result_;
  }

  const ReplayOptions& options_;
  TapeReader tape_;
  DrivenParticipant participant_;
  NetworkPlaces places_;
  ReplayResult result_;
  Seconds patience_ = patience_for_hello;
  std::optional<std::string> unanswered_;  ///< the last command, while it has no answer
  double said_live_ = 0, begin_live_ = 0;
  Clock::time_point said_{}, begin_{};
  bool released_ = false, started_by_debugger_ = false;
  pid_t pid_ = 0;
};

}  // namespace

ReplayResult replay(const ReplayOptions& options) {
  ReplayResult result = Replay(options).run();
  end_descendants({});
  return result;
}

}  // namespace fissura::coupler
