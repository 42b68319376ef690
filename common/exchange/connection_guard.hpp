// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/exchange/channel.hpp"

namespace zmq {
class context_t;
class socket_t;
}  // namespace zmq

namespace fissura {

/// Watches the connections of the coupler's socket from a thread of its own, so that strangers are dealt with
/// while the coupler works: it closes the oldest of them where there are too many, logs each kind of trouble
/// at most once a minute, and tells which connections ended and how. File descriptors are reused, so
/// connections have numbers.
class ConnectionGuard {
 public:
  using Number = std::uint64_t;

  struct Ended {
    Number connection = 0;
    Loss how = Loss::closed;
  };

  /// @param watched  a socket of `context`, not yet bound
  /// @param most     connections at a time; participants' own are never closed
  ConnectionGuard(zmq::context_t& context, zmq::socket_t& watched, std::size_t most);
  ~ConnectionGuard();
  ConnectionGuard(const ConnectionGuard&) = delete;
  ConnectionGuard& operator=(const ConnectionGuard&) = delete;

  /// Readable while ended() has something to give.
  [[nodiscard]] int descriptor() const;

  /// Connections asked for with connection_of() that ended since the last call.
  std::vector<Ended> ended();

  /// The connection that a message came on; nothing if it has ended. From now on ended() tells of it.
  std::optional<Number> connection_of(int file_descriptor);

  /// It is a participant's.
  void keep(Number connection);

  /// Ends a connection, if it has not ended by itself.
  void cut(Number connection);

  /// Logs "a peer was WHAT", at most once a minute for each `kind`, with the number of those not logged.
  void note(const std::string& kind, const std::string& what);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fissura
