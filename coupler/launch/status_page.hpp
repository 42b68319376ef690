// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

namespace fissura::coupler {

/// What the worker shows the supervisor, on a page of memory both have mapped: what it is doing, and that it still moves.
class StatusPage {
 public:
  StatusPage();
  ~StatusPage();
  StatusPage(const StatusPage&) = delete;
  StatusPage& operator=(const StatusPage&) = delete;

  /// Worker: still moving. Cheap.
  void beat() { content_->beats.fetch_add(1, std::memory_order_relaxed); }
  /// Worker: what it is doing; `phase` must be a literal.
  void show(std::uint64_t interval, const char* phase);

  [[nodiscard]] std::uint64_t beats() const { return content_->beats.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t interval() const { return content_->interval.load(std::memory_order_relaxed); }
  [[nodiscard]] const char* phase() const { return content_->phase.load(std::memory_order_relaxed); }

  /// Supervisor: end the run at the next coupling time; `signal` says why.
  void request_stop(int signal) { content_->stop_signal.store(signal, std::memory_order_relaxed); }
  /// Worker: the signal of request_stop, or 0.
  [[nodiscard]] int stop_signal() const { return content_->stop_signal.load(std::memory_order_relaxed); }

 private:
  struct Content {
    std::atomic<std::uint64_t> beats{0};
    std::atomic<std::uint64_t> interval{0};
    std::atomic<const char*> phase{"start"};
    std::atomic<int> stop_signal{0};
  };
  Content* content_;
};

}  // namespace fissura::coupler
