// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/session.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#include "common/exchange/array_units.hpp"
#include "common/exchange/floating_point.hpp"
#include "common/exchange/held_signals.hpp"
#include "common/exchange/progress.hpp"
#include "common/exchange/stack_dump.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "common/log.hpp"

namespace fissura {

namespace {

/// The coupler is gone, silent, or wants nothing of this participant: there is nobody left to tell.
struct CouplerLost : Error {
  using Error::Error;
};

void spoil(Message& message, const Spoil& spoil) {
  for (Array& array : message.arrays) {
    const bool meant = spoil.field.empty() || array.name == spoil.field;
    double value = 0;
    if (!meant || array.dtype != "float64" || array.bytes.size() / sizeof(value) <= spoil.index) continue;
    std::byte* place = array.bytes.data() + spoil.index * sizeof(value);
    std::memcpy(&value, place, sizeof(value));
    const double opposite = value == 0 ? -1.0 : -std::abs(value);
    value = spoil.how == FaultAction::nan ? std::numeric_limits<double>::quiet_NaN() : opposite;
    std::memcpy(place, &value, sizeof(value));
    return;
  }
  log::warn(fmt::format("nothing to spoil: the reply has no value {} in \"{}\"", spoil.index, spoil.field));
}

/// Adds the wall time of its life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += Seconds(std::chrono::steady_clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

ParticipantState state_after(const ParticipantStep& step, std::optional<Word> reply) {
  for (std::size_t i = 0; i < step.outcome_count; ++i)
    if (step.outcomes[i].reply == reply) return step.outcomes[i].next;
  throw Error(ExitCode::internal,
              fmt::format("{} is no answer to \"{}\"", reply ? name(*reply) : "silence", name(step.action)));
}

}  // namespace

Session::Session(Role role, const ParticipantOptions& options, Solver& solver)
    : role_(role),
      options_(options),
      solver_(solver),
      channel_(options.endpoint, options.keys, Seconds(options.coupler_deadline)),
      deadline_(options.coupler_deadline) {}

Session::~Session() {
  set_progress_report({});
}

int Session::run() {
  try {
    arm_planned_faults(name(role_));
    greet();
    while (state_ != ParticipantState::leaving && state_ != ParticipantState::ended) take(next_message());
    wait_for_release();
    return static_cast<int>(ExitCode::done);
  } catch (const CouplerLost& loss) {
    log::error(fmt::format("{} (interval {}, phase {})", loss.what(), interval_, last_phase()));
    return static_cast<int>(loss.code());
  } catch (const Error& failure) {
    return report_failure(failure.code(), failure.what());
  } catch (const std::bad_alloc&) {
    return report_failure(ExitCode::out_of_memory, "out of memory");
  } catch (const std::exception& failure) {
    return report_failure(ExitCode::internal, failure.what());
  }
}

// ---- what comes -------------------------------------------------------------------------------------

void Session::greet() {
  begin_phase("hello");
  Message hello(MessageType::hello);
  hello.body = {{"role", name(role_)},
                {"solver", options_.solver_name},
                {"version", options_.solver_version},
                {"pid", ::getpid()},
                {"capabilities", {"insert", "report", "save", "restore"}}};
  if (dumps_stack()) hello.body["capabilities"].push_back("stack");
  solver_.introduce(hello.body);
  channel_.send(std::move(hello));
}

Message Session::next_message() {
  if (kept_) return *std::exchange(kept_, std::nullopt);
  Seconds waited{0};
  const Seconds patience{0.5};
  while (waited < deadline_) {
    auto event = channel_.receive(patience);
    if (std::holds_alternative<ConnectionLost>(event))
      throw CouplerLost(ExitCode::participant_died, "the coupler is gone: its connection broke");
    if (Message* message = std::get_if<Message>(&event)) return std::move(*message);
    waited += patience;
    pass_on_signal();
  }
  throw CouplerLost(ExitCode::participant_unresponsive,
                    fmt::format("the coupler has said nothing for {} s", deadline_.count()));
}

// What comes while the solver is at work must be taken: left in the queue, it would one day leave no room for
// heartbeats.
void Session::hear_coupler() {
  for (;;) {
    auto event = channel_.receive(Seconds(0));
    if (std::holds_alternative<ConnectionLost>(event))
      throw CouplerLost(ExitCode::participant_died, "the coupler is gone: its connection broke");
    Message* message = std::get_if<Message>(&event);
    if (message == nullptr) return;
    take(std::move(*message));
  }
}

void Session::report_progress(const char* phase, unsigned long count) {
  Message progress(MessageType::progress);
  progress.interval = interval_;
  progress.body = {{"phase", phase}, {"count", count}};
  if (const std::optional<int> signal = held_signal()) progress.body["stop_signal"] = *signal;
  channel_.send(std::move(progress));
  hear_coupler();
}

// A signal that asks this process to end asks the run to end: the coupler does so at its next coupling time.
void Session::pass_on_signal() {
  const std::optional<int> signal = held_signal();
  if (!signal) return;
  Message progress(MessageType::progress);
  progress.interval = interval_;
  progress.body = {{"phase", last_phase()}, {"count", 0}, {"stop_signal", *signal}};
  channel_.send(std::move(progress));
}

// ---- what follows from it ---------------------------------------------------------------------------

void Session::take(Message message) {
  const Word word = word_of(message);
  const ParticipantReaction& rule = reaction(role_, state_, word);
  if (const auto* fault = std::get_if<ProtocolFault>(&rule)) refuse(word, *fault);
  if (const std::optional<std::string> fault = wrong_unit(message)) throw Error(ExitCode::mismatch, *fault);
  const auto& step = std::get<ParticipantStep>(rule);
  state_ = state_during(step.action, state_);
  state_ = state_after(step, carry_out(step.action, std::move(message)));
}

void Session::refuse(Word word, ProtocolFault fault) const {
  throw ProtocolError(fmt::format("{} came, but {} (state {}, fault {})", name(word), sentence(fault),
                                  name(state_), name(fault)));
}

std::optional<Word> Session::carry_out(ParticipantAction action, Message message) {
  switch (action) {
    case ParticipantAction::join:
    case ParticipantAction::insert:
    case ParticipantAction::advance:
    case ParticipantAction::report:
    case ParticipantAction::save:
    case ParticipantAction::restore:
    case ParticipantAction::finish:
      return work(action, message);
    case ParticipantAction::keep:
      if (kept_) refuse(word_of(message), ProtocolFault::at_work);
      kept_ = std::move(message);
      break;
    case ParticipantAction::hear:
    case ParticipantAction::ignore:
    case ParticipantAction::leave:
      break;
    case ParticipantAction::accept_no: {
      const int code = message.body.value("exit_code", static_cast<int>(ExitCode::mismatch));
      throw CouplerLost(static_cast<ExitCode>(code),
                        "the coupler refused this participant: " + message.value<std::string>("reason"));
    }
    case ParticipantAction::stop:
      throw CouplerLost(ExitCode::participant_died,
                        "the coupler ended the run: " + message.value<std::string>("reason"));
  }
  return std::nullopt;
}

// ---- the solver's work ------------------------------------------------------------------------------

std::optional<Word> Session::work(ParticipantAction action, const Message& command) {
  interval_ = command.interval;
  const Stopwatch work(work_seconds_);
  begin_phase(name(action));
  switch (action) {
    case ParticipantAction::join:
      return join(command);
    case ParticipantAction::insert:
      return insert(command);
    case ParticipantAction::advance:
      return advance(command);
    case ParticipantAction::report:
      return report(command);
    case ParticipantAction::save:
      return save();
    case ParticipantAction::restore:
      return restore(command);
    case ParticipantAction::finish:
      return finish();
    case ParticipantAction::keep:
    case ParticipantAction::hear:
    case ParticipantAction::ignore:
    case ParticipantAction::leave:
    case ParticipantAction::accept_no:
    case ParticipantAction::stop:
      break;
  }
  return std::nullopt;
}

/// Every phase of a participant begins here: hello, the names of the actions that are work, and answer.
std::optional<Spoil> Session::begin_phase(const char* phase) {
  set_phase(phase);
  return fault_point(phase, interval_);
}

std::optional<Word> Session::join(const Message& welcome) {
  deadline_ = Seconds(welcome.value<double>("coupler_deadline"));
  const bool resumes = word_of(welcome) == Word::welcome_resuming;
  set_progress_report([this](const char* phase, unsigned long count) { report_progress(phase, count); });
  solver_.join({welcome.value<nlohmann::json>("case"), welcome.value<int>("threads"), resumes});
  if (role_ != Role::structure || resumes) return std::nullopt;
  const Insertion first = solver_.first_topology();
  network_.apply(first);
  Message topology;
  topology.body["insertion"] = insertion_to_json(first);
  solver_.describe_state(topology);
  return reply(MessageType::topology, std::move(topology));
}

Word Session::insert(const Message& command) {
  const Insertion insertion = insertion_from_json(command.value<nlohmann::json>("insertion"));
  // The structure has given revision 0 itself; it comes back as the first INSERT and only has to agree.
  const bool own_first = role_ == Role::structure && insertion.revision == 0;
  if (!own_first) {
    network_.apply(insertion);
    if (solver_.insert(insertion) != network_.topology_hash())
      throw ProtocolError(fmt::format("the solver's topology differs after revision {}", insertion.revision));
  }
  return reply(MessageType::acknowledge, network_and_state());
}

Word Session::advance(const Message& command) {
  require_revision(command);
  Message answer = solver_.advance(command);
  return reply(role_ == Role::network ? MessageType::pressure : MessageType::response, std::move(answer));
}

Word Session::report(const Message& command) {
  require_revision(command);
  return reply(MessageType::fields, solver_.report(command));
}

Word Session::save() {
  Message state;
  state.add_bytes("state", solver_.save());
  solver_.describe_neutral_state(state);
  return reply(MessageType::state, std::move(state));
}

// The topology comes from the coupler, not from the state: so both participants start from the same one.
Word Session::restore(const Message& command) {
  std::vector<Insertion> insertions;
  FractureNetwork network;
  for (const nlohmann::json& insertion : command.value<nlohmann::json>("insertions")) {
    insertions.push_back(insertion_from_json(insertion));
    network.apply(insertions.back());
  }
  if (network.empty()) throw ProtocolError("RESTORE brings no topology");
  const std::optional<std::string> hash =
      command.has("state") ? solver_.restore(command.bytes("state")) : solver_.take_up(command, insertions);
  if (hash && *hash != network.topology_hash())
    throw Error(ExitCode::checkpoint_unusable, "the state belongs to another topology than RESTORE brings");
  network_ = std::move(network);
  return reply(MessageType::restored, network_and_state());
}

Word Session::finish() {
  Message bye;
  bye.body["figures"] = solver_.finish();
  bye.body["figures"]["work_seconds"] = work_seconds_;
  return reply(MessageType::bye, std::move(bye));
}

void Session::require_revision(const Message& command) const {
  if (command.revision != network_.revision())
    throw ProtocolError(fmt::format("{} is made for topology revision {}, this participant has {}",
                                    name(command.type), command.revision, network_.revision()));
}

/// What shows that coupler and participant are at the same place.
Message Session::network_and_state() {
  Message answer;
  answer.body["hash"] = network_.topology_hash();
  if (role_ == Role::structure) solver_.describe_state(answer);
  return answer;
}

Word Session::reply(MessageType type, Message message) {
  const std::optional<Spoil> spoilt = begin_phase("answer");
  if (const std::optional<std::string> change = changed_floating_point())
    throw ProtocolError(fmt::format("the solver has left floating-point arithmetic changed: {}", *change));
  if (spoilt) spoil(message, *spoilt);
  message.type = type;
  message.interval = interval_;
  message.revision = network_.empty() ? 0 : network_.revision();
  const Word word = word_of(message);
  channel_.send(std::move(message));
  set_phase("waiting");
  return word;
}

// ---- the end ----------------------------------------------------------------------------------------

// What is on its way when a process ends may be lost with its connection, so the last word is only over when
// the coupler has it.
void Session::wait_for_release() {
  constexpr Seconds longest{2.0};
  const auto start = std::chrono::steady_clock::now();
  while (state_ != ParticipantState::ended && std::chrono::steady_clock::now() - start < longest) {
    auto event = channel_.receive(Seconds(0.1));
    if (std::holds_alternative<ConnectionLost>(event)) return;
    if (Message* message = std::get_if<Message>(&event)) take(std::move(*message));
  }
}

int Session::report_failure(ExitCode code, const std::string& reason) {
  log::error(fmt::format("interval {}, phase {}: {}", interval_, last_phase(), reason));
  set_progress_report({});
  state_ = ParticipantState::failed;
  try {
    Message failure(MessageType::fail);
    failure.interval = interval_;
    failure.body = {{"role", name(role_)},
                    {"phase", last_phase()},
                    {"reason", reason},
                    {"exit_code", static_cast<int>(code)}};
    channel_.send(std::move(failure));
    wait_for_release();
  } catch (const std::exception& second) {
    log::error(fmt::format("the coupler could not be told: {}", second.what()));
  }
  return static_cast<int>(code);
}

}  // namespace fissura
