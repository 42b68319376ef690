// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/faults/proxy.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>

#include "common/errors.hpp"
#include "common/exchange/held_signals.hpp"
#include "coupler/faults/relay.hpp"
#include "coupler/faults/transcript.hpp"
#include "coupler/launch/child_process.hpp"

namespace fissura::coupler {

namespace {

constexpr double tick = 0.05;  // wall seconds between looks at signals
constexpr double last_words =
    0.1;                        // wall seconds in which a message of a process that ended may still arrive
constexpr double farewell = 3;  // wall seconds a participant may take to end without a coupler

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::uint64_t epoch_of_environment() {
  const char* text = std::getenv("FISSURA_EPOCH");
  return text == nullptr ? 0 : std::strtoull(text, nullptr, 10);
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return result + "'";
}

/// A folder of this user's own for one socket. The name of the socket is removed as soon as it is no longer
/// needed.
class PrivateSocket {
 public:
  PrivateSocket() {
    std::string pattern = (std::filesystem::temp_directory_path() / "fissura-proxy-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw Error(ExitCode::precondition, "cannot create " + pattern);
    folder_ = pattern;
  }
  ~PrivateSocket() { remove(); }
  PrivateSocket(const PrivateSocket&) = delete;
  PrivateSocket& operator=(const PrivateSocket&) = delete;

  [[nodiscard]] std::string endpoint() const { return "ipc://" + (folder_ / "socket").string(); }
  void remove() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 private:
  std::filesystem::path folder_;
};

std::vector<MessageFault> faults_of(const FaultPlan& plan, const std::string& role, std::uint64_t epoch) {
  std::vector<MessageFault> faults;
  for (const MessageFault& each : plan.messages)
    if (each.role == role && each.epoch.value_or(epoch) == epoch) faults.push_back(each);
  return faults;
}

class Proxy {
 public:
  explicit Proxy(const ProxyOptions& options)
      : transcript_(options.transcript, epoch_of_environment()),
        relay_(faults_of(read_fault_plan(options.plan), options.role, epoch_of_environment()),
               [this](Direction direction, const Frames& message, const std::string& did) {
                 transcript_.note(direction, message, did);
               }),
        coupler_(FrameLink::connected(options.endpoint)),
        participant_(FrameLink::listening(socket_.endpoint())),
        process_(
            {"/bin/sh", "-c", fmt::format("exec {} --connect '{}'", options.command, socket_.endpoint())}) {}

  ProcessEnd run() {
    while (!process_.end()) {
      wait();
      while (const std::optional<int> signal = held_signal()) process_.send_signal(*signal);
      carry();
      watch_connections();
    }
    hear_last_words();
    coupler_.close();
    return *process_.end();
  }

 private:
  void wait() {
    double longest = tick;
    if (const std::optional<double> next = relay_.next_time()) longest = std::clamp(*next - now(), 0.0, tick);
    wait_for_any(coupler_, participant_, process_.descriptor(),
                 std::chrono::milliseconds(static_cast<long>(longest * 1000 + 1)));
  }

  void carry() {
    while (std::optional<Frames> message = participant_.receive()) {
      socket_.remove();
      relay_.take(Direction::to_coupler, std::move(*message), now());
    }
    while (std::optional<Frames> message = coupler_.receive())
      relay_.take(Direction::to_participant, std::move(*message), now());
    while (const std::optional<Frames> message = relay_.next(Direction::to_coupler, now()))
      coupler_.send(*message);
    while (const std::optional<Frames> message = relay_.next(Direction::to_participant, now()))
      participant_.send(*message);
    if (relay_.is_cut()) {
      coupler_.cut();
      participant_.cut();
    }
  }

  /// A connection that breaks on one side breaks on the other. A participant that only stands still is
  /// imitated.
  void watch_connections() {
    if (participant_.lost()) {
      if (process_.stopped()) {
        ::raise(SIGSTOP);
      } else if (!process_.wait(last_words)) {
        coupler_.close();
      }
    }
    if (coupler_.lost()) {
      participant_.close();
      if (!process_.wait(farewell)) process_.send_signal(SIGKILL);
    }
  }

  void hear_last_words() {
    const double start = now();
    while (!participant_.lost() && now() - start < last_words) {
      carry();
      wait();
    }
    carry();
  }

  PrivateSocket socket_;
  Transcript transcript_;
  Relay relay_;
  FrameLink coupler_;
  FrameLink participant_;
  ChildProcess process_;
};

int end_like(const ProcessEnd& end) {
  if (!end.signal) return end.exit_code;
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  std::signal(*end.signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::raise(*end.signal);
  return 128 + *end.signal;
}

}  // namespace

std::string behind_proxy(const std::string& proxy_program, const std::filesystem::path& plan,
                         const std::string& role, const std::filesystem::path& transcript,
                         const std::string& command) {
  return fmt::format("{} --plan {} --role {} --transcript {} --command {}", proxy_program,
                     quoted(plan.string()), role, quoted(transcript.string()), quoted(command));
}

int run_proxy(const ProxyOptions& options) {
  // Ctrl-C reaches the whole terminal group; only the coupler decides what it means.
  std::signal(SIGINT, SIG_IGN);
  hold_signals({SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2});
  const ProcessEnd end = [&] { return Proxy(options).run(); }();
  return end_like(end);
}

}  // namespace fissura::coupler
