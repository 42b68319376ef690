// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/launch/trio.hpp"

#include <fmt/format.h>

#include <cctype>
#include <csignal>
#include <cstring>
#include <utility>

#include "common/exchange/array_units.hpp"
#include "common/flow_solver/flow_case.hpp"
#include "common/log.hpp"
#include "coupler/launch/executable_check.hpp"
#include "coupler/launch/signals.hpp"

namespace fissura::coupler {

namespace {

constexpr Seconds tick{0.05};
constexpr double farewell = 0.5;  // wall seconds a participant may take to end after being told
constexpr double parting = 0.15;  // wall seconds between the end of a connection and that of its process
constexpr int most_at_once = 256;
constexpr double patience_for_a_debugger = 1e9;  // wall seconds

double since(std::chrono::steady_clock::time_point start) {
  return Seconds(std::chrono::steady_clock::now() - start).count();
}

std::string hexadecimal(const RunId& run) {
  std::string text;
  for (const std::uint8_t byte : run) text += fmt::format("{:02x}", byte);
  return text;
}

/// The phase in which a participant begins to carry out a command: "advance" for ADVANCE.
std::string first_phase(MessageType command) {
  std::string phase = name(command);
  for (char& letter : phase) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return phase;
}

bool may_be_said(const CouplerMove& move) {
  return std::holds_alternative<CouplerView>(move);
}

}  // namespace

Trio::Trio(const TrioOptions& options, const RunId& run, std::uint32_t epoch, StatusPage& status)
    : options_(options), status_(status), channel_(options.listening, run, epoch), run_id_(hexadecimal(run)) {
  participants_[0].role = Role::structure;
  participants_[1].role = Role::network;
  for (Participant& each : participants_) each.ladder = ProgressLadder(options.deadlines.progress);
  if (options.observer != nullptr) channel_.observe(*options.observer);
}

Trio::~Trio() = default;

// ---- the conversation -------------------------------------------------------------------------------

void Trio::start(const nlohmann::json& run_case, Start start) {
  run_case_ = run_case;
  start_ = start;
  for (Participant& each : participants_) start_process(each);
  for (const Participant& each : participants_)
    while (each.view == CouplerView::absent) handle_next_event(tick);
}

void Trio::start_process(Participant& each) {
  each.last_word = each.asked_at = Clock::now();
  const std::optional<std::string>& command = options_.command[static_cast<std::size_t>(each.role)];
  if (command) {
    if (const std::optional<std::string> reason = why_not_executable(*command))
      fail(ExitCode::precondition, each, "cannot be started: " + *reason);
    each.process.emplace(std::vector<std::string>{
        "/bin/sh", "-c", fmt::format("exec {}{} --connect '{}'", *command, options_.more_words, channel_.endpoint())});
    each.memory.emplace(each.process->pid());
    deaths_.add(each.process->descriptor(), static_cast<std::size_t>(each.role));
  }
  if (!command)
    log::info(
        fmt::format("waiting for the {} to connect to {}", name(each.role), options_.listening.endpoint));
  show(each);
}

void Trio::send(Role role, Message command) {
  Participant& target = participant(role);
  require_allowed(target, word_of(command));
  target.asked = name(command.type);
  target.phase = first_phase(command.type);
  target.interval = command.interval;
  target.revision = command.revision;
  target.last_word = target.asked_at = Clock::now();
  target.answer.reset();
  say(target, std::move(command));
  show(target);
}

void Trio::require_allowed(const Participant& target, Word word) {
  if (const auto* fault = std::get_if<ProtocolFault>(&move(target.role, target.view, word)))
    throw Error(ExitCode::internal, fmt::format("the coupler would have said {} to the {}, but {} (view {}, fault {})",
                                                name(word), name(target.role), sentence(*fault), name(target.view),
                                                name(*fault)));
}

void Trio::say(Participant& target, Message message) {
  const Word word = word_of(message);
  require_allowed(target, word);
  target.view = std::get<CouplerView>(move(target.role, target.view, word));
  try {
    channel_.send(*target.peer, std::move(message));
  } catch (const ProtocolError& fault) {
    // A peer that has just died cannot be written to: what it said last, or how it ended, is the better
    // reason.
    if (target.process && target.process->wait(parting)) process_ended(target);
    hear_last_words(target);
    if (target.process && target.process->stopped())
      fail(ExitCode::participant_unresponsive, target, "is stopped by a signal");
    fail(ExitCode::protocol_violation, target, fault.what());
  }
}

Message Trio::await(Role role, MessageType expected) {
  Participant& source = participant(role);
  ENSURE(source.answer || is_waited_for(source.view));
  const Clock::time_point begin = Clock::now();
  while (!source.answer) handle_next_event(tick);
  source.waited += since(begin);
  ENSURE(source.answer->type == expected);
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
  for (const Role role : {Role::structure, Role::network}) {
    const Message bye = await(role, MessageType::bye);
    const auto given = bye.body.find("figures");
    const bool whole = given != bye.body.end() && given->is_object();
    figures[static_cast<std::size_t>(role)] = whole ? *given : nlohmann::json::object();
  }
  for (Participant& each : participants_) wait_for_end(each);
  return figures;
}

void Trio::abort(const std::string& reason) {
  for (Participant& each : participants_) {
    if (!each.peer || (each.process && each.process->end())) continue;
    if (!may_be_said(move(each.role, each.view, Word::fail))) continue;
    each.view = CouplerView::gone;
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

// ---- what comes -------------------------------------------------------------------------------------

void Trio::handle_next_event(Seconds patience) {
  status_.beat();
  pass_on_signals(status_);
  // Silence is judged only when all that has been said is heard: this process may have been busy or held up
  // itself.
  bool all_heard = false;
  for (int count = 0; count < most_at_once && !all_heard; ++count)
    all_heard = !handle(channel_.wait(count == 0 ? patience : Seconds(0), {deaths_.descriptor()}));
  watch_processes();
  if (all_heard)
    for (Participant& each : participants_) watch_silence(each);
  keep_alive();
}

/// @returns whether more may be waiting
bool Trio::handle(CouplerChannel::Event&& event) {
  if (auto* received = std::get_if<CouplerChannel::Received>(&event)) {
    for (Participant& each : participants_)
      if (each.peer == received->peer) {
        try {
          hear(each, std::move(received->message));
        } catch (const nlohmann::json::exception& fault) {
          fail(ExitCode::protocol_violation, each,
               fmt::format("sent a body that cannot be read: {}", fault.what()));
        }
        return true;
      }
    hear_stranger(*received);
    return true;
  }
  if (auto* fault = std::get_if<CouplerChannel::PeerFault>(&event)) {
    for (Participant& each : participants_)
      if (each.peer == fault->peer)
        fail(ExitCode::protocol_violation, each, "sent nonsense: " + fault->reason);
    refuse(fault->peer, fault->greeting ? ExitCode::mismatch : ExitCode::protocol_violation, fault->reason,
           fault->greeting.value_or(nlohmann::json::object()));
    return true;
  }
  if (auto* lost = std::get_if<CouplerChannel::PeerLost>(&event)) {
    for (Participant& each : participants_)
      if (each.peer == lost->peer) peer_lost(each, lost->how);
    return true;
  }
  return false;
}

void Trio::hear(Participant& each, Message&& message) {
  const Word word = word_of(message);
  const CouplerReaction& rule = reaction(each.role, each.view, word);
  if (const auto* fault = std::get_if<ProtocolFault>(&rule))
    fail(ExitCode::protocol_violation, each,
         fmt::format("sent {}, but {} (view {}, fault {})", name(word), sentence(*fault), name(each.view),
                     name(*fault)));
  const auto& step = std::get<CouplerStep>(rule);
  const CouplerView asked_in = std::exchange(each.view, step.next);
  each.last_word = Clock::now();
  switch (step.action) {
    case CouplerAction::take:
      take(each, asked_in, std::move(message));
      break;
    case CouplerAction::release:
      take(each, asked_in, std::move(message));
      if (each.process) deaths_.remove(each.process->descriptor());
      say(each, Message(MessageType::bye));
      break;
    case CouplerAction::note:
      hear_progress(each, message);
      break;
    case CouplerAction::hear_failure:
      hear_failure(each, message);
    case CouplerAction::greet:
    case CouplerAction::ignore:
      break;
  }
  show(each);
}

/// An answer that fits the question: the same interval, and the same topology where its arrays depend on it.
void Trio::take(Participant& each, CouplerView asked_in, Message&& answer) {
  if (answer.interval != each.interval)
    fail(ExitCode::protocol_violation, each,
         fmt::format("sent {} of interval {}, but was asked for interval {}", name(answer.type), answer.interval, each.interval));
  const bool has_arrays = asked_in == CouplerView::inserting || asked_in == CouplerView::advancing ||
                          asked_in == CouplerView::reporting || asked_in == CouplerView::reporting_proposed;
  if (has_arrays && answer.revision != each.revision)
    fail(ExitCode::protocol_violation, each,
         fmt::format("sent {}, which is made for topology revision {}, the network has {}", name(answer.type),
                     answer.revision, each.revision));
  if (const std::optional<std::string> fault = wrong_unit(answer))
    fail(ExitCode::mismatch, each, "sent " + *fault);
  each.phase = "waiting";
  each.answer = std::move(answer);
}

void Trio::hear_progress(Participant& each, const Message& message) {
  each.phase = message.body.value("phase", each.phase);
  each.count = message.body.value("count", each.count);
  hear_stop_request(each, message);
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

void Trio::hear_failure(Participant& each, const Message& message) {
  each.phase = message.body.value("phase", each.phase);
  const int code = message.body.value("exit_code", static_cast<int>(ExitCode::internal));
  const bool ours =
      code >= static_cast<int>(ExitCode::case_invalid) && code <= static_cast<int>(ExitCode::internal);
  fail(ours ? static_cast<ExitCode>(code) : ExitCode::internal, each,
       "reports: " + message.body.value("reason", std::string("no reason")));
}

// ---- who takes part ---------------------------------------------------------------------------------

void Trio::hear_stranger(const CouplerChannel::Received& received) {
  const PeerNumber peer = received.peer;
  const Message& message = received.message;
  const Word word = word_of(message);
  if (word != Word::hello) {
    channel_.dismiss(peer, fmt::format("is no participant and sent {}", name(message.type)));
    return;
  }
  try {
    const auto role_text = message.value<std::string>("role");
    if (received.proven_role.value_or(role_text) != role_text) {
      refuse(peer, ExitCode::security,
             fmt::format("it claims the role {} with the key of the role {}", role_text,
                         *received.proven_role),
             message.body);
      return;
    }
    for (Participant& each : participants_) {
      if (role_text != name(each.role)) continue;
      if (std::holds_alternative<ProtocolFault>(reaction(each.role, each.view, word)))
        refuse(peer, ExitCode::role_taken,
               fmt::format("the role {} is held by process {} since {:.0f} s", role_text, each.identity.pid,
                           since(each.joined)),
               message.body);
      else
        greet(peer, each, message);
      return;
    }
    refuse(peer, ExitCode::mismatch, "there is no role " + role_text, message.body);
  } catch (const ProtocolError& fault) {
    refuse(peer, ExitCode::mismatch, fmt::format("its HELLO is wrong: {}", fault.what()), message.body);
  }
}

void Trio::greet(PeerNumber peer, Participant& each, const Message& hello) {
  ParticipantIdentity identity{
      hello.value<std::string>("solver"), hello.value<std::string>("version"), hello.value<long>("pid"), {}};
  if (hello.body.contains("capabilities"))
    identity.capabilities = hello.value<std::set<std::string, std::less<>>>("capabilities");
  if (start_ == Start::resuming && !identity.capabilities.contains("restore")) {
    refuse(peer, ExitCode::mismatch, fmt::format("{} cannot take up a run at a checkpoint", identity.solver),
           hello.body);
    return;
  }
  if (const std::optional<std::string> missing = unclaimed_physics(each.role, hello)) {
    refuse(peer, ExitCode::mismatch,
           fmt::format("this case needs {}, which {} does not claim", *missing, identity.solver), hello.body);
    return;
  }
  each.peer = peer;
  each.identity = std::move(identity);
  each.joined = each.last_word = each.asked_at = Clock::now();
  each.asked = "WELCOME";
  each.phase = "join";
  if (each.process) each.memory.emplace(each.process->pid());
  Message welcome(MessageType::welcome);
  welcome.body = {{"run_id", run_id_},
                  {"case", run_case_},
                  {"resumes", start_ == Start::resuming},
                  {"threads", each.role == Role::structure ? options_.threads : 1},
                  {"coupler_deadline", options_.debug_attach ? patience_for_a_debugger : options_.deadlines.progress}};
  say(each, std::move(welcome));
  show(each);
}

/// Names, in words; nothing if the participant claims all or tells of no physics at all.
std::optional<std::string> Trio::unclaimed_physics(Role role, const Message& hello) const {
  if (role != Role::network || !hello.body.contains("physics")) return std::nullopt;
  const auto claimed = hello.value<std::set<std::string>>("physics");
  std::string missing;
  for (const std::string& needed : needed_physics(run_case_))
    if (!claimed.contains(needed)) missing += (missing.empty() ? "" : ", ") + needed;
  return missing.empty() ? std::nullopt : std::optional(missing);
}

// A stranger does not disturb the run; but if it is the process that was to take the part, the run cannot
// begin.
void Trio::refuse(PeerNumber peer, ExitCode code, const std::string& reason, const nlohmann::json& hello) {
  channel_.note(name(code), "refused: " + reason);
  Message message(MessageType::reject);
  message.body = {{"reason", reason}, {"exit_code", static_cast<int>(code)}};
  try {
    channel_.send(peer, std::move(message));
  } catch (const ProtocolError& fault) {
    log::warn(fault.what());
  }
  const auto pid = hello.find("pid");
  for (Participant& each : participants_) {
    if (each.view != CouplerView::absent) continue;
    each.refusal.emplace(code, reason);
    if (each.process && pid != hello.end() && *pid == each.process->pid())
      fail(code, each, "was refused: " + reason);
  }
}

std::string Trio::situation(const Participant& participant) const {
  return fmt::format("interval {}, asked for {}, phase {}", participant.interval, participant.asked,
                     participant.phase);
}

void Trio::fail(ExitCode code, const Participant& participant, const std::string& cause) {
  throw ParticipantFailure(code, participant.role,
                           fmt::format("{} {} ({})", name(participant.role), cause, situation(participant)));
}

}  // namespace fissura::coupler
