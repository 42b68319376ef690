// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/participant.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include "common/exchange/channel.hpp"
#include "common/exchange/fault_point.hpp"
#include "common/exchange/held_signals.hpp"
#include "common/exchange/progress.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "common/log.hpp"

namespace fissura {

namespace {

/// The coupler is gone or silent: there is nobody left to tell.
struct CouplerLost : Error {
  using Error::Error;
};

void spoil(Message& message) {
  for (Array& array : message.arrays) {
    if (array.dtype != "float64" || array.bytes.empty()) continue;
    const double poison = std::numeric_limits<double>::quiet_NaN();
    const auto* bytes = reinterpret_cast<const std::byte*>(&poison);
    std::copy(bytes, bytes + sizeof(poison), array.bytes.begin());
    return;
  }
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

class Session {
 public:
  Session(Role role, const ParticipantOptions& options, Solver& solver)
      : role_(role),
        options_(options),
        solver_(solver),
        channel_(options.endpoint),
        fault_(fault_plan_of_environment(name(role))),
        deadline_(options.coupler_deadline) {}

  int run() {
    try {
      join();
      while (serve(receive()) == Next::go_on) {
      }
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

 private:
  enum class Next { go_on, end };

  void join() {
    Message hello(MessageType::hello);
    hello.body = {{"role", name(role_)},
                  {"solver", options_.solver_name},
                  {"version", options_.solver_version},
                  {"pid", ::getpid()},
                  {"capabilities", {"insert", "report", "save", "restore"}}};
    channel_.send(std::move(hello));
    const Message answer = receive();
    if (answer.type == MessageType::reject)
      throw Error(ExitCode::mismatch, "the coupler refused this participant: " + answer.value<std::string>("reason"));
    if (answer.type != MessageType::welcome)
      throw ProtocolError(fmt::format("expected WELCOME, received {}", name(answer.type)));
    deadline_ = Seconds(answer.value<double>("coupler_deadline"));
    set_progress_report([this](const char* phase, unsigned long count) {
      Message progress(MessageType::progress);
      progress.interval = interval_;
      progress.body = {{"phase", phase}, {"count", count}};
      if (const std::optional<int> signal = held_signal()) progress.body["stop_signal"] = *signal;
      channel_.send(std::move(progress));
      hear_coupler();
    });
    const bool resumes = answer.body.contains("resumes") && answer.value<bool>("resumes");
    joining_ = true;
    solver_.join({answer.value<nlohmann::json>("case"), answer.value<int>("threads"), resumes});
    joining_ = false;
    if (role_ == Role::structure && !resumes) send_first_topology();
  }

  void send_first_topology() {
    const Insertion first = solver_.first_topology();
    network_.apply(first);
    Message topology(MessageType::topology);
    topology.body["insertion"] = insertion_to_json(first);
    solver_.describe_state(topology);
    channel_.send(std::move(topology));
  }

  /// A command, or nothing if the message is the coupler's own PROGRESS, which only shows that it lives.
  static std::optional<Message> command_in(Message&& message) {
    if (message.type == MessageType::progress) return std::nullopt;
    if (message.type == MessageType::fail)
      throw CouplerLost(ExitCode::participant_died,
                        "the coupler ended the run: " + message.value<std::string>("reason"));
    return std::move(message);
  }

  /// Takes what the coupler sends to a solver at work: left in the queue, it would one day leave no room for heartbeats.
  void hear_coupler() {
    for (;;) {
      auto event = channel_.receive(Seconds(0));
      if (std::holds_alternative<ConnectionLost>(event))
        throw CouplerLost(ExitCode::participant_died, "the coupler is gone: its connection broke");
      Message* message = std::get_if<Message>(&event);
      if (message == nullptr) return;
      auto command = command_in(std::move(*message));
      if (!command) continue;
      // The coupler does not hear when a solver has joined: its first command may be there before.
      if (!joining_ || kept_)
        throw ProtocolError(fmt::format("{} came while the solver was at work", name(command->type)));
      kept_ = std::move(command);
    }
  }

  /// The next command.
  Message receive() {
    if (kept_) return *std::exchange(kept_, std::nullopt);
    Seconds waited{0};
    const Seconds patience{0.5};
    while (waited < deadline_) {
      auto event = channel_.receive(patience);
      if (std::holds_alternative<ConnectionLost>(event))
        throw CouplerLost(ExitCode::participant_died, "the coupler is gone: its connection broke");
      if (Message* message = std::get_if<Message>(&event)) {
        if (auto command = command_in(std::move(*message))) return std::move(*command);
        waited = Seconds(0);
        continue;
      }
      waited += patience;
      pass_on_signal();
    }
    throw CouplerLost(ExitCode::participant_unresponsive,
                      fmt::format("the coupler has said nothing for {} s", deadline_.count()));
  }

  /// A signal that asks this process to end asks the run to end: the coupler does so at its next coupling time.
  void pass_on_signal() {
    const std::optional<int> signal = held_signal();
    if (!signal) return;
    Message progress(MessageType::progress);
    progress.interval = interval_;
    progress.body = {{"phase", last_phase()}, {"count", 0}, {"stop_signal", *signal}};
    channel_.send(std::move(progress));
  }

  Next serve(Message command) {
    interval_ = command.interval;
    const Stopwatch work(work_seconds_);
    switch (command.type) {
      case MessageType::advance: advance(command); return Next::go_on;
      case MessageType::insert: insert(command); return Next::go_on;
      case MessageType::report: {
        require_revision(command);
        Message fields = solver_.report(command);
        reply(MessageType::fields, std::move(fields));
        return Next::go_on;
      }
      case MessageType::save: {
        if (proposed_) throw ProtocolError("SAVE came while an insertion is proposed");
        Message state;
        const std::vector<std::byte> blob = solver_.save();
        state.add_bytes("state", blob);
        reply(MessageType::state, std::move(state));
        return Next::go_on;
      }
      case MessageType::restore: restore(command); return Next::go_on;
      case MessageType::finish: {
        Message bye;
        bye.body["figures"] = solver_.finish();
        bye.body["figures"]["work_seconds"] = work_seconds_;
        reply(MessageType::bye, std::move(bye));
        wait_for_release();
        return Next::end;
      }
      default:
        throw ProtocolError(fmt::format("{} is not a command for a {}", name(command.type), name(role_)));
    }
  }

  void advance(const Message& command) {
    require_revision(command);
    const bool poisoned = fault_point(fault_, interval_);
    Message answer = solver_.advance(command);
    proposed_ = answer.body.contains("insertion");
    if (poisoned) spoil(answer);
    reply(role_ == Role::network ? MessageType::pressure : MessageType::response, std::move(answer));
  }

  void insert(const Message& command) {
    const Insertion insertion = insertion_from_json(command.value<nlohmann::json>("insertion"));
    // The structure has given revision 0 itself; it comes back as the first INSERT and only has to agree.
    const bool own_first = role_ == Role::structure && insertion.revision == 0;
    std::string solver_hash;
    if (!own_first) {
      network_.apply(insertion);
      solver_hash = solver_.insert(insertion);
    }
    if (!own_first && solver_hash != network_.topology_hash())
      throw ProtocolError(fmt::format("the solver's topology differs after revision {}", insertion.revision));
    proposed_ = false;
    reply(MessageType::acknowledge, network_and_state());
  }

  /// The topology comes from the coupler, not from the state: so both participants start from the same one.
  void restore(const Message& command) {
    if (!network_.empty()) throw ProtocolError("RESTORE came to a participant that has a topology already");
    FractureNetwork network;
    for (const nlohmann::json& insertion : command.value<nlohmann::json>("insertions"))
      network.apply(insertion_from_json(insertion));
    if (network.empty()) throw ProtocolError("RESTORE brings no topology");
    solver_.restore(command.bytes("state"));
    network_ = std::move(network);
    reply(MessageType::restored, network_and_state());
  }

  /// What shows that coupler and participant are at the same place.
  Message network_and_state() {
    Message answer;
    answer.body["hash"] = network_.topology_hash();
    if (role_ == Role::structure) solver_.describe_state(answer);
    return answer;
  }

  void require_revision(const Message& command) const {
    if (network_.empty() || command.revision != network_.revision())
      throw ProtocolError(fmt::format("{} is made for topology revision {}, this participant has {}",
                                      name(command.type), command.revision,
                                      network_.empty() ? "none" : std::to_string(network_.revision())));
  }

  void reply(MessageType type, Message message) {
    message.type = type;
    message.interval = interval_;
    message.revision = network_.empty() ? 0 : network_.revision();
    channel_.send(std::move(message));
  }

  // What is on its way when a process ends may be lost with its connection, so the last word is only over when the coupler has it.
  void wait_for_release() {
    constexpr Seconds longest{2.0};
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < longest) {
      const auto event = channel_.receive(Seconds(0.1));
      if (std::holds_alternative<ConnectionLost>(event)) return;
      const Message* message = std::get_if<Message>(&event);
      if (message != nullptr && (message->type == MessageType::bye || message->type == MessageType::fail)) return;
    }
  }

  int report_failure(ExitCode code, const std::string& reason) {
    log::error(fmt::format("interval {}, phase {}: {}", interval_, last_phase(), reason));
    set_progress_report({});
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

  Role role_;
  const ParticipantOptions& options_;
  Solver& solver_;
  ParticipantChannel channel_;
  std::optional<FaultPlan> fault_;
  Seconds deadline_;
  FractureNetwork network_;
  bool proposed_ = false;  ///< an insertion that has not come yet
  bool joining_ = false;
  std::optional<Message> kept_;  ///< a command that came while the solver joined
  std::uint64_t interval_ = 0;
  double work_seconds_ = 0;  ///< wall time between command and reply
};

}  // namespace

const char* name(Role role) { return role == Role::structure ? "structure" : "network"; }

int run_participant(Role role, const ParticipantOptions& options, Solver& solver) {
  int code = 0;
  {
    Session session(role, options, solver);
    code = session.run();
    set_progress_report({});
  }
  return code;
}

int participant_main(Role role, int argc, char** argv, const char* solver_name, Solver& solver) {
  CLI::App program(fmt::format("Fissura {} participant: started by the coupler", name(role)));
  ParticipantOptions options;
  options.solver_name = solver_name;
  options.solver_version = FISSURA_VERSION;
  std::string level = "info";
  program.add_option("--connect", options.endpoint, "endpoint of the coupler")->required();
  program.add_option("--log", level, "debug, info, warn or error");
  program.set_version_flag("--version", options.solver_version);
  try {
    program.parse(argc, argv);
    log::start(name(role), level);
    // Ctrl-C reaches the whole terminal group; only the coupler decides what it means.
    std::signal(SIGINT, SIG_IGN);
    hold_signals({SIGTERM, SIGHUP});
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    return run_participant(role, options, solver);
  } catch (const CLI::ParseError& fault) {
    return program.exit(fault) == 0 ? 0 : static_cast<int>(ExitCode::command_line);
  } catch (const Error& fault) {
    std::fprintf(stderr, "%s: %s: %s\n", name(role), fissura::name(fault.code()), fault.what());
    return static_cast<int>(fault.code());
  }
}

}  // namespace fissura
