// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/exchange/curve_keys.hpp"

namespace zmq {
class context_t;
class socket_t;
}  // namespace zmq

namespace fissura {

/// Lets into a ZeroMQ context only holders of allowed keys (ZAP, https://rfc.zeromq.org/spec/27): answers
/// every connection to a socket of the coupler with the role of its key, or refuses it. A thread of its own,
/// so that a connection is judged while the coupler works.
class KeyCheck {
 public:
  /// To be made before any socket of `context` is bound, and to outlive them.
  KeyCheck(zmq::context_t& context, const CouplerKeys& keys);
  ~KeyCheck();
  KeyCheck(const KeyCheck&) = delete;
  KeyCheck& operator=(const KeyCheck&) = delete;

  /// Makes `socket` a CURVE server whose connections are judged here. To be called before bind.
  void guard(zmq::socket_t& socket) const;

  /// Goes the whole way of a participant once, over loopback, with a key made for it: a mistake in keys or
  /// domain is found before anybody relies on them. Throws Error(security), or Error(precondition) if there
  /// is no loopback.
  void prove();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Makes `socket` a CURVE client. To be called before connect.
void use_keys(zmq::socket_t& socket, const ParticipantKeys& keys);

}  // namespace fissura
