// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/trio.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstring>

#include "common/log.hpp"
#include "coupler/launch/signals.hpp"

namespace fissura::coupler {

namespace {

constexpr Seconds tick{0.05};
constexpr Seconds keep_alive_interval{1.0};
constexpr double stop_tolerance = 1.0;   // wall seconds a participant may be stopped
constexpr double last_words = 0.1;       // wall seconds in which a message of a process that ended may still arrive
constexpr double farewell = 0.5;         // wall seconds a participant may take to end after being told

double since(std::chrono::steady_clock::time_point start) {
  return Seconds(std::chrono::steady_clock::now() - start).count();
}

std::string hexadecimal(const RunId& run) {
  std::string text;
  for (const std::uint8_t byte : run) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace

Trio::Trio(const TrioOptions& options, const RunId& run, std::uint32_t epoch, StatusPage& status)
    : options_(options), status_(status), channel_(options.endpoint, run, epoch), run_id_(hexadecimal(run)) {
  participants_[0].role = Role::structure;
  participants_[1].role = Role::network;
}

Trio::~Trio() = default;

void Trio::start(const nlohmann::json& run_case, Start start) {
  run_case_ = run_case;
  start_ = start;
  for (Participant& each : participants_) {
    each.last_word = Clock::now();
    const std::optional<std::string>& command = options_.command[static_cast<std::size_t>(each.role)];
    if (!command) continue;
    each.process.emplace(std::vector<std::string>{
        "/bin/sh", "-c", fmt::format("exec {} --connect '{}'", *command, channel_.endpoint())});
  }
  for (Participant& each : participants_)
    while (!each.peer) {
      handle_next_event(tick);
      check_silence(each, options_.deadlines.join);
    }
}

void Trio::send(Role role, Message command) {
  Participant& target = participant(role);
  target.asked = name(command.type);
  target.interval = command.interval;
  target.last_word = Clock::now();
  target.answer.reset();
  try {
    channel_.send(*target.peer, std::move(command));
  } catch (const ProtocolError& fault) {
    // A peer that has just died cannot be written to: what it said last, or how it ended, is the better reason.
    hear_last_words();
    watch_processes();
    fail(ExitCode::protocol_violation, target, fault.what());
  }
}

Message Trio::await(Role role, MessageType expected) {
  Participant& source = participant(role);
  const Clock::time_point begin = Clock::now();
  while (!source.answer) {
    handle_next_event(tick);
    // Meshing comes between WELCOME and TOPOLOGY or RESTORED.
    const bool joining = expected == MessageType::topology || expected == MessageType::restored;
    if (!source.answer) check_silence(source, joining ? options_.deadlines.join : options_.deadlines.progress);
  }
  source.waited += since(begin);
  if (source.answer->type != expected)
    fail(ExitCode::protocol_violation, source,
         fmt::format("sent {} where {} was expected", name(source.answer->type), name(expected)));
  Message answer = std::move(*source.answer);
  source.answer.reset();
  return answer;
}

Message Trio::request(Role role, Message command, MessageType expected) {
  send(role, std::move(command));
  return await(role, expected);
}

std::array<nlohmann::json, 2> Trio::finish() {
  for (const Role role : {Role::structure, Role::network}) send(role, Message(MessageType::finish));
  std::array<nlohmann::json, 2> figures;
  for (const Role role : {Role::structure, Role::network})
    figures[static_cast<std::size_t>(role)] =
        await(role, MessageType::bye).body.value("figures", nlohmann::json::object());
  for (Participant& each : participants_) {
    if (!each.process) continue;
    const ProcessEnd end = each.process->wait_or_kill(options_.deadlines.finish);
    if (end.signal || end.exit_code != 0)
      fail(ExitCode::participant_died, each, "said BYE, then " + end.sentence());
  }
  return figures;
}

void Trio::abort(const std::string& reason) {
  ending_ = true;
  for (Participant& each : participants_) {
    if (!each.peer || (each.process && each.process->end())) continue;
    Message message(MessageType::fail);
    message.body = {{"role", "coupler"}, {"phase", status_.phase()}, {"reason", reason}, {"exit_code", 0}};
    try {
      channel_.send(*each.peer, std::move(message));
    } catch (const Error&) {
      continue;
    }
  }
  for (Participant& each : participants_)
    if (each.process) each.process->wait_or_kill(each.peer && !each.process->stopped() ? farewell : 0);
}

void Trio::handle_next_event(Seconds patience) {
  status_.beat();
  pass_on_signals(status_);
  std::vector<int> descriptors;
  for (Participant& each : participants_)
    if (each.process && !each.said_bye && !each.process->end()) descriptors.push_back(each.process->descriptor());
  CouplerChannel::Event event = channel_.wait(patience, descriptors);
  if (auto* received = std::get_if<CouplerChannel::Received>(&event)) {
    handle(std::move(*received));
  } else if (auto* fault = std::get_if<CouplerChannel::PeerFault>(&event)) {
    for (Participant& each : participants_)
      if (each.peer == fault->peer) fail(ExitCode::protocol_violation, each, "sent nonsense: " + fault->reason);
    log::warn("an unknown peer was ignored: " + fault->reason);
  } else if (auto* lost = std::get_if<CouplerChannel::PeerLost>(&event)) {
    for (Participant& each : participants_) {
      if (each.peer != lost->peer || each.said_bye) continue;
      if (each.process && each.process->wait(farewell)) watch_processes();
      if (each.process && each.process->stopped()) fail(ExitCode::participant_unresponsive, each, "is stopped by a signal");
      fail(ExitCode::participant_died, each, "closed its connection");
    }
  } else {
    watch_processes();
  }
  keep_alive();
}

void Trio::handle(CouplerChannel::Received&& received) {
  Message& message = received.message;
  if (message.type == MessageType::hello) {
    greet(received.peer, message);
    return;
  }
  for (Participant& each : participants_) {
    if (each.peer != received.peer) continue;
    each.last_word = Clock::now();
    if (message.type == MessageType::progress) {
      each.phase = message.body.value("phase", each.phase);
      hear_stop_request(each, message);
    } else if (message.type == MessageType::fail) {
      each.phase = message.body.value("phase", each.phase);
      const int code = message.body.value("exit_code", static_cast<int>(ExitCode::internal));
      fail(static_cast<ExitCode>(code), each, "reports: " + message.body.value("reason", std::string("no reason")));
    } else if (each.answer || each.said_bye) {
      fail(ExitCode::protocol_violation, each, fmt::format("sent {} without being asked", name(message.type)));
    } else {
      each.said_bye = message.type == MessageType::bye;
      each.answer = std::move(message);
      if (each.said_bye) channel_.send(received.peer, Message(MessageType::bye));
    }
    return;
  }
  log::warn(fmt::format("{} from an unknown peer was ignored", name(message.type)));
}

/// A participant that was told to end is still needed until the next coupling time.
void Trio::hear_stop_request(const Participant& participant, const Message& progress) {
  const auto told = progress.body.find("stop_signal");
  if (told == progress.body.end() || status_.stop_signal() != 0) return;
  const int signal = *told == SIGHUP ? SIGHUP : SIGTERM;
  log::warn(fmt::format("{} was asked to end by signal {} ({}): the run ends at the next coupling time",
                        name(participant.role), signal, ::strsignal(signal)));
  status_.request_stop(signal);
}

void Trio::greet(PeerNumber peer, const Message& hello) {
  const auto role_text = hello.value<std::string>("role");
  for (Participant& each : participants_) {
    if (role_text != name(each.role)) continue;
    if (each.peer) {
      reject(peer, fmt::format("the role {} is held by process {}", role_text, each.identity.pid));
      return;
    }
    each.peer = peer;
    each.identity = {hello.value<std::string>("solver"), hello.value<std::string>("version"),
                     hello.value<long>("pid")};
    each.last_word = Clock::now();
    each.asked = "WELCOME";
    Message welcome(MessageType::welcome);
    welcome.body = {{"run_id", run_id_},
                    {"case", run_case_},
                    {"resumes", start_ == Start::resuming},
                    {"threads", each.role == Role::structure ? options_.threads : 1},
                    {"coupler_deadline", options_.deadlines.progress}};
    channel_.send(peer, std::move(welcome));
    return;
  }
  reject(peer, "there is no role " + role_text);
}

void Trio::reject(PeerNumber peer, const std::string& reason) {
  log::warn("a participant was refused: " + reason);
  Message message(MessageType::reject);
  message.body["reason"] = reason;
  channel_.send(peer, std::move(message));
}

void Trio::watch_processes() {
  for (Participant& each : participants_) {
    if (!each.process || each.said_bye || ending_) continue;
    if (const std::optional<ProcessEnd> end = each.process->end()) {
      hear_last_words();
      const bool silent = !end->signal && !each.peer;
      fail(ExitCode::participant_died, each, end->sentence() + (silent ? " before it introduced itself" : ""));
    }
    if (!each.process->stopped()) {
      each.stopped_since.reset();
    } else if (!each.stopped_since) {
      each.stopped_since = Clock::now();
    } else if (since(*each.stopped_since) > stop_tolerance) {
      fail(ExitCode::participant_unresponsive, each, "is stopped by a signal");
    }
  }
}

// What a participant still managed to say goes before how it ended.
void Trio::hear_last_words() {
  const Clock::time_point start = Clock::now();
  while (since(start) < last_words) {
    CouplerChannel::Event event = channel_.wait(tick, {});
    if (auto* received = std::get_if<CouplerChannel::Received>(&event)) handle(std::move(*received));
  }
}

void Trio::check_silence(Participant& waiting_for, double deadline) {
  if (since(waiting_for.last_word) <= deadline) return;
  watch_processes();
  if (!waiting_for.peer)
    fail(ExitCode::participant_unresponsive, waiting_for, fmt::format("did not introduce itself in {} s", deadline));
  fail(ExitCode::participant_unresponsive, waiting_for, fmt::format("is alive but made no progress for {} s", deadline));
}

void Trio::keep_alive() {
  const Clock::time_point now = Clock::now();
  if (now < next_keep_alive_) return;
  next_keep_alive_ = now + std::chrono::duration_cast<Clock::duration>(keep_alive_interval);
  for (Participant& each : participants_) {
    if (!each.peer || each.said_bye || (each.process && each.process->end())) continue;
    Message progress(MessageType::progress);
    progress.body = {{"phase", status_.phase()}, {"count", status_.beats()}};
    try {
      channel_.send(*each.peer, std::move(progress));
    } catch (const ProtocolError&) {
      // A stopped participant does not empty its queue; watch_processes tells.
    }
  }
}

std::string Trio::situation(const Participant& participant) const {
  return fmt::format("interval {}, asked for {}, phase {}", participant.interval, participant.asked, participant.phase);
}

void Trio::fail(ExitCode code, const Participant& participant, const std::string& cause) {
  throw ParticipantFailure(code, participant.role,
                           fmt::format("{} {} ({})", name(participant.role), cause, situation(participant)));
}

}  // namespace fissura::coupler
