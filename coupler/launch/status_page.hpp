// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace fissura::coupler {

/// A short text of fixed room, so that it can lie in memory that processes share; longer ones are cut.
template <std::size_t room>
struct ShortText {
  std::array<char, room> characters{};

  ShortText() = default;
  ShortText& operator=(std::string_view text) {
    characters.fill('\0');
    text.copy(characters.data(), room - 1);
    return *this;
  }
  [[nodiscard]] std::string text() const { return characters.data(); }
};

/// What the coupler knows of one participant. Times are those of the monotonic clock of this machine [s].
struct ParticipantStatus {
  ShortText<16> asked;         ///< last command; empty before it introduced itself
  ShortText<48> phase;         ///< as of its last PROGRESS, or with which it begins the command
  std::uint64_t interval = 0;  ///< of the last command
  std::uint64_t count = 0;     ///< of its solve loop, as of its last PROGRESS
  double asked_at = 0;         ///< when it got that command
  double last_word = 0;        ///< when it last said anything
  std::int64_t pid = 0;        ///< 0 if it was not started here
  bool is_waited_for = false;  ///< an answer is outstanding
};

/// What a run is doing. Plain values only: it lies in memory that processes share.
struct RunStatus {
  std::uint64_t interval = 0;
  ShortText<32> phase;
  double phase_since = 0;                             ///< monotonic clock [s]
  std::uint32_t epoch = 0;                            ///< how often the run was resumed
  double started_at = 0;                              ///< of this epoch, monotonic clock [s]
  double started_time = 0;                            ///< simulated time at which this epoch began [s]
  double time = 0, end = 0;                           ///< simulated: reached, and where the run ends [s]
  double duration = 0;                                ///< of the last coupling interval [s]
  double drift = 0;                                   ///< of the last coupling interval [-]
  double injected = 0, in_fractures = 0, leaked = 0;  ///< [m3]
  double ledger_residual = 0;                         ///< relative [-]
  std::uint64_t insertions = 0;                       ///< changes of the topology after revision 0
  std::uint64_t checkpoints = 0;                      ///< written in this epoch
  std::uint64_t checkpoint_interval = 0;              ///< of the newest one; meaningless without any
  double checkpoint_time = 0;                         ///< simulated [s]
  bool has_checkpoint = false;                        ///< of any epoch
  std::array<ParticipantStatus, 2> participants;      ///< by Role
};

/// Why a run ended, for its last line. `exit_code` 0: it has not failed.
struct RunFailure {
  int exit_code = 0;
  ShortText<16> who;  ///< "coupler", "structure" or "network"
  std::uint64_t interval = 0;
  ShortText<32> phase;
  ShortText<2048> sentence;
};

/// What the worker shows its supervisor and everybody who asks (`coupler status`): one small file that all
/// have mapped. Only the worker changes the status; the supervisor only asks.
class StatusPage {
 public:
  /// Without a file: for the processes forked from here.
  StatusPage();
  /// Creates `file` at its full size, or takes it over. Throws StorageError.
  explicit StatusPage(const std::filesystem::path& file);
  ~StatusPage();
  StatusPage(const StatusPage&) = delete;
  StatusPage& operator=(const StatusPage&) = delete;

  /// Worker: still moving. Cheap.
  void beat() { content_->beats.fetch_add(1, std::memory_order_relaxed); }
  /// Worker: what it is doing.
  void show(std::uint64_t interval, const char* phase);
  /// Worker: changes the status with `change(RunStatus&)`; readers see all of it or nothing.
  template <typename Change>
  void change(const Change& change) {
    begin_change();
    change(content_->status);
    end_change();
  }
  /// Worker: why the run ends.
  void fail(const RunFailure& failure);

  [[nodiscard]] std::uint64_t beats() const { return content_->beats.load(std::memory_order_relaxed); }
  /// The status now; as the worker left it if it died in the middle of a change.
  [[nodiscard]] RunStatus read() const;
  [[nodiscard]] std::uint64_t interval() const { return read().interval; }
  [[nodiscard]] std::string phase() const { return read().phase.text(); }
  /// Of fail(), since the last clear_failure().
  [[nodiscard]] RunFailure failure() const { return content_->failure; }
  void clear_failure() { content_->failure = {}; }

  /// Supervisor: before it forks a worker: no failure, no conclusion, no change half done by the one before.
  void begin_life();
  /// In the worker, last of all: it has come to its end by itself, with this exit code.
  void conclude(int exit_code) { content_->conclusion.store(exit_code, std::memory_order_release); }
  /// The exit code of conclude(); nothing if this worker has not come so far.
  [[nodiscard]] std::optional<int> conclusion() const;

  /// Supervisor: end the run at the next coupling time; `signal` says why.
  void request_stop(int signal) { content_->stop_signal.store(signal, std::memory_order_relaxed); }
  /// Worker: the signal of request_stop, or 0.
  [[nodiscard]] int stop_signal() const { return content_->stop_signal.load(std::memory_order_relaxed); }

  /// Supervisor: write a checkpoint at the next coupling time.
  void request_checkpoint() { content_->checkpoints_wanted.fetch_add(1, std::memory_order_relaxed); }
  /// Worker: how often request_checkpoint was called.
  [[nodiscard]] std::uint64_t checkpoints_requested() const {
    return content_->checkpoints_wanted.load(std::memory_order_relaxed);
  }

 private:
  struct Content {
    std::uint64_t magic = 0;  ///< layout of the page
    std::atomic<std::uint64_t> beats{0};
    std::atomic<std::uint64_t> changes{0};  ///< odd while the status is being changed
    std::atomic<int> stop_signal{0};
    std::atomic<int> conclusion{-1};  ///< -1: none yet
    std::atomic<std::uint64_t> checkpoints_wanted{0};
    RunStatus status;
    RunFailure failure;
  };
  friend std::optional<RunStatus> read_status(const std::filesystem::path& file);
  void map(int descriptor, int flags);
  void begin_change();
  void end_change();
  static RunStatus consistent(const Content& content);

  Content* content_ = nullptr;
};

/// What the page in `file` shows; nothing if there is none, or it has another layout.
std::optional<RunStatus> read_status(const std::filesystem::path& file);

/// Of the monotonic clock that the status uses [s].
double monotonic_seconds();

}  // namespace fissura::coupler
