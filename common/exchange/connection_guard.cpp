// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/connection_guard.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <zmq.hpp>

#include "common/errors.hpp"
#include "common/exchange/frames.hpp"
#include "common/exchange/quiet_thread.hpp"
#include "common/log.hpp"

namespace fissura {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* reports_address = "inproc://connections";
constexpr int watched_events = ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_ACCEPT_FAILED | ZMQ_EVENT_DISCONNECTED |
                               ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL |
                               ZMQ_EVENT_HANDSHAKE_FAILED_AUTH;

class EventFlag {
 public:
  EventFlag() : descriptor_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    if (descriptor_ < 0) throw Error(ExitCode::precondition, "no file descriptor is left");
  }
  ~EventFlag() { ::close(descriptor_); }
  EventFlag(const EventFlag&) = delete;
  EventFlag& operator=(const EventFlag&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  void raise() const {
    const std::uint64_t one = 1;
    (void)!::write(descriptor_, &one, sizeof(one));
  }
  void lower() const {
    std::uint64_t count = 0;
    (void)!::read(descriptor_, &count, sizeof(count));
  }

 private:
  int descriptor_;
};

/// One line of each kind a minute.
class SparseLog {
 public:
  void note(const std::string& name, const std::string& what) {
    const Clock::time_point now = Clock::now();
    Kind& kind = kinds_[name];
    if (kind.last && now - *kind.last < std::chrono::minutes(1)) {
      ++kind.suppressed;
      return;
    }
    const std::string more = kind.suppressed > 0 ? fmt::format(" (and {} more since)", kind.suppressed) : "";
    log::warn("a peer was " + what + more);
    kind = {now, 0};
  }

 private:
  struct Kind {
    std::optional<Clock::time_point> last;
    std::uint64_t suppressed = 0;
  };
  std::map<std::string, Kind> kinds_;
};

/// How a connection ended, told by a duplicate of its descriptor that is still open.
Loss loss_of(int duplicate) {
  // The transport stops reading at the first thing it cannot accept; the rest stays, or comes now.
  constexpr int moment_ms = 50;
  pollfd state{duplicate, POLLIN | POLLRDHUP, 0};
  ::poll(&state, 1, moment_ms);
  if ((state.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0) return Loss::closed;
  int unread = 0;
  if (::ioctl(duplicate, FIONREAD, &unread) == 0 && unread > 0) return Loss::broke_framing;
  return Loss::fell_silent;
}

}  // namespace

class ConnectionGuard::Implementation {
 public:
  Implementation(zmq::context_t& context, zmq::socket_t& watched, std::size_t most)
      : watched_(watched), reports_(context, zmq::socket_type::pair), most_(most) {
    if (zmq_socket_monitor(watched.handle(), reports_address, watched_events) != 0)
      throw Error(ExitCode::internal, "cannot watch the connections");
    reports_.set(zmq::sockopt::linger, 0);
    // A queue that is full would stop the transport.
    reports_.set(zmq::sockopt::rcvhwm, 0);
    reports_.connect(reports_address);
    thread_ = quiet_thread([this] { watch(); });
  }

  ~Implementation() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.raise();
    thread_.join();
    zmq_socket_monitor(watched_.handle(), nullptr, 0);
    for (auto& [descriptor, connection] : connections_) forget(connection);
  }

  [[nodiscard]] int descriptor() const { return news_.descriptor(); }

  std::vector<Ended> ended() {
    const std::lock_guard lock(mutex_);
    news_.lower();
    return std::exchange(ended_, {});
  }

  std::optional<Number> connection_of(int file_descriptor) {
    std::unique_lock lock(mutex_);
    const std::uint64_t wanted = ++rounds_wanted_;
    wake_.raise();
    round_done_.wait(lock, [&] { return rounds_done_ >= wanted; });
    const auto found = connections_.find(file_descriptor);
    if (found == connections_.end()) return std::nullopt;
    if (found->second.duplicate < 0) found->second.duplicate = ::fcntl(file_descriptor, F_DUPFD_CLOEXEC, 0);
    return found->second.number;
  }

  void keep(Number number) {
    const std::lock_guard lock(mutex_);
    if (Connection* connection = find(number)) connection->kept = true;
  }

  void cut(Number number) {
    const std::lock_guard lock(mutex_);
    if (Connection* connection = find(number); connection != nullptr && connection->duplicate >= 0)
      ::shutdown(connection->duplicate, SHUT_RDWR);
  }

  void note(const std::string& kind, const std::string& what) {
    const std::lock_guard lock(mutex_);
    log_.note(kind, what);
  }

 private:
  struct Connection {
    Number number = 0;
    int duplicate = -1;  ///< of its descriptor, once it has said something
    bool kept = false;
    bool cut = false;
  };

  void watch() {
    for (;;) {
      zmq::pollitem_t items[] = {{reports_.handle(), 0, ZMQ_POLLIN, 0},
                                 {nullptr, wake_.descriptor(), ZMQ_POLLIN, 0}};
      zmq_poll(items, 2, -1);
      const std::lock_guard lock(mutex_);
      wake_.lower();
      if (stop_) return;
      const std::uint64_t round = rounds_wanted_;
      // All reports first: until then a descriptor may be that of another connection already.
      for (std::vector<zmq::message_t> report = receive_frames(reports_); !report.empty();
           report = receive_frames(reports_))
        hear(report[0]);
      close_surplus();
      rounds_done_ = round;
      round_done_.notify_all();
    }
  }

  void hear(const zmq::message_t& report) {
    std::uint16_t event = 0;
    std::uint32_t value = 0;
    std::memcpy(&event, report.data<char>(), sizeof(event));
    std::memcpy(&value, report.data<char>() + sizeof(event), sizeof(value));
    const int descriptor = static_cast<int>(value);
    switch (event) {
      case ZMQ_EVENT_ACCEPTED: {
        if (const auto stale = connections_.find(descriptor); stale != connections_.end())
          forget(stale->second);
        Connection connection;
        connection.number = next_number_++;
        connections_[descriptor] = connection;
        return;
      }
      case ZMQ_EVENT_DISCONNECTED:
        end(descriptor);
        return;
      case ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL:
        log_.note("silent", "refused: it connected, but said nothing that makes sense within 2 s");
        return;
      case ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL:
        log_.note("handshake",
                  "refused: it has no keys, or takes this for another coupler, or does not speak ZMTP");
        return;
      case ZMQ_EVENT_HANDSHAKE_FAILED_AUTH:
        log_.note("key", "refused: its key is not among those of this run");
        return;
      case ZMQ_EVENT_ACCEPT_FAILED:
        log_.note("files", "not let in: the system gives no more file descriptors");
        return;
      default:
        return;
    }
  }

  void end(int descriptor) {
    const auto found = connections_.find(descriptor);
    if (found == connections_.end()) return;
    if (found->second.duplicate >= 0) {
      ended_.push_back(
          {found->second.number, found->second.kept ? loss_of(found->second.duplicate) : Loss::closed});
      news_.raise();
    }
    forget(found->second);
    connections_.erase(found);
  }

  void close_surplus() {
    std::vector<std::pair<Number, int>> strangers;
    std::size_t open = 0;
    for (const auto& [descriptor, connection] : connections_) {
      if (!connection.cut) ++open;
      if (!connection.cut && !connection.kept) strangers.emplace_back(connection.number, descriptor);
    }
    if (open <= most_) return;
    std::sort(strangers.begin(), strangers.end());
    strangers.resize(std::min(strangers.size(), open - most_));
    for (const auto& [number, descriptor] : strangers) {
      Connection& connection = connections_.at(descriptor);
      connection.cut = true;
      ::shutdown(connection.duplicate >= 0 ? connection.duplicate : descriptor, SHUT_RDWR);
      log_.note("surplus", fmt::format("cut off: there are more than {} connections", most_));
    }
  }

  Connection* find(Number number) {
    for (auto& [descriptor, connection] : connections_)
      if (connection.number == number) return &connection;
    return nullptr;
  }

  static void forget(Connection& connection) {
    if (connection.duplicate >= 0) ::close(connection.duplicate);
    connection.duplicate = -1;
  }

  zmq::socket_t& watched_;
  zmq::socket_t reports_;
  const std::size_t most_;
  EventFlag wake_, news_;
  std::mutex mutex_;  ///< of everything below
  std::condition_variable round_done_;
  std::map<int, Connection> connections_;  ///< by file descriptor
  std::vector<Ended> ended_;
  SparseLog log_;
  Number next_number_ = 1;
  std::uint64_t rounds_wanted_ = 0, rounds_done_ = 0;
  bool stop_ = false;
  std::thread thread_;
};

ConnectionGuard::ConnectionGuard(zmq::context_t& context, zmq::socket_t& watched, std::size_t most)
    : implementation_(std::make_unique<Implementation>(context, watched, most)) {}
ConnectionGuard::~ConnectionGuard() = default;
int ConnectionGuard::descriptor() const {
  return implementation_->descriptor();
}
std::vector<ConnectionGuard::Ended> ConnectionGuard::ended() {
  return implementation_->ended();
}
std::optional<ConnectionGuard::Number> ConnectionGuard::connection_of(int file_descriptor) {
  return implementation_->connection_of(file_descriptor);
}
void ConnectionGuard::keep(Number connection) {
  implementation_->keep(connection);
}
void ConnectionGuard::cut(Number connection) {
  implementation_->cut(connection);
}
void ConnectionGuard::note(const std::string& kind, const std::string& what) {
  implementation_->note(kind, what);
}

}  // namespace fissura
