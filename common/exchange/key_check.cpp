// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/key_check.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <thread>
#include <zmq.hpp>

#include "common/errors.hpp"
#include "common/exchange/frames.hpp"
#include "common/exchange/quiet_thread.hpp"

namespace fissura {

namespace {

constexpr const char* domain = "fissura";
constexpr const char* handler_address = "inproc://zeromq.zap.01";
constexpr const char* control_address = "inproc://key-check-control";
constexpr std::size_t raw_key_length = 32;

}  // namespace

class KeyCheck::Implementation {
 public:
  Implementation(zmq::context_t& context, const CouplerKeys& keys)
      : context_(context),
        own_(keys.own),
        requests_(context, zmq::socket_type::rep),
        stop_here_(context, zmq::socket_type::pair),
        stop_there_(context, zmq::socket_type::pair) {
    for (const AllowedKey& each : keys.allowed) roles_[each.public_key] = each.role;
    requests_.set(zmq::sockopt::linger, 0);
    requests_.bind(handler_address);
    stop_there_.bind(control_address);
    stop_here_.connect(control_address);
    thread_ = quiet_thread([this] { serve(); });
  }

  ~Implementation() {
    (void)stop_here_.send(zmq::message_t(), zmq::send_flags::dontwait);
    thread_.join();
  }

  void guard(zmq::socket_t& socket) const {
    socket.set(zmq::sockopt::curve_server, true);
    socket.set(zmq::sockopt::curve_secretkey, own_.secret_key);
    socket.set(zmq::sockopt::curve_publickey, own_.public_key);
    socket.set(zmq::sockopt::zap_domain, domain);
  }

  void prove() {
    const KeyPair visitor = new_key_pair();
    allow(visitor.public_key, "visitor");
    zmq::socket_t server(context_, zmq::socket_type::router), client(context_, zmq::socket_type::dealer);
    for (zmq::socket_t* socket : {&server, &client}) set_common_options(*socket, smallest_frame_bound);
    client.set(zmq::sockopt::linger, 0);
    guard(server);
    use_keys(client, {visitor, own_.public_key});
    try {
      server.bind("tcp://127.0.0.1:*");
      client.connect(server.get(zmq::sockopt::last_endpoint));
    } catch (const zmq::error_t& fault) {
      throw Error(ExitCode::precondition,
                  fmt::format("the keys cannot be tried, there is no loopback network: {}", fault.what()));
    }
    client.send(zmq::str_buffer("visit"), zmq::send_flags::dontwait);
    const std::optional<std::string> role = role_of_first_message(server);
    forbid(visitor.public_key);
    if (role != "visitor")
      throw Error(ExitCode::security,
                  "a connection with a good key was not let in: keys or their check do not work");
  }

 private:
  void allow(const std::string& public_key, const std::string& role) {
    const std::lock_guard lock(mutex_);
    roles_[public_key] = role;
  }
  void forbid(const std::string& public_key) {
    const std::lock_guard lock(mutex_);
    roles_.erase(public_key);
  }

  static std::optional<std::string> role_of_first_message(zmq::socket_t& server) {
    constexpr std::chrono::duration<double> patience{2.0};
    zmq::pollitem_t item{server.handle(), 0, ZMQ_POLLIN, 0};
    poll({&item, 1}, patience);
    const std::vector<zmq::message_t> frames = receive_frames(server);
    return frames.empty() ? std::nullopt : proven_role(frames.back());
  }

  void serve() {
    for (;;) {
      zmq::pollitem_t items[] = {{requests_.handle(), 0, ZMQ_POLLIN, 0},
                                 {stop_there_.handle(), 0, ZMQ_POLLIN, 0}};
      try {
        zmq::poll(items, 2, std::chrono::milliseconds(-1));
        if (items[1].revents != 0) return;
        answer(receive_frames(requests_));
      } catch (const zmq::error_t& fault) {
        if (fault.num() == ETERM) return;
      }
    }
  }

  void answer(const std::vector<zmq::message_t>& request) {
    if (request.size() < 2) return;
    const std::optional<std::string> role = role_of(request);
    const std::array<std::string, 6> reply{request[0].to_string(), request[1].to_string(),
                                           role ? "200" : "400",   role ? "" : "unknown key",
                                           role.value_or(""),      ""};
    for (std::size_t i = 0; i < reply.size(); ++i)
      requests_.send(zmq::buffer(reply[i]),
                     i + 1 < reply.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
  }

  /// @param request  version, number, domain, address, identity, mechanism, credentials
  std::optional<std::string> role_of(const std::vector<zmq::message_t>& request) {
    if (request.size() != 7 || request[0].to_string_view() != "1.0" ||
        request[2].to_string_view() != domain || request[5].to_string_view() != "CURVE" ||
        request[6].size() != raw_key_length)
      return std::nullopt;
    std::array<char, 41> key{};
    zmq_z85_encode(key.data(), request[6].data<std::uint8_t>(), raw_key_length);
    const std::lock_guard lock(mutex_);
    const auto found = roles_.find(key.data());
    return found == roles_.end() ? std::nullopt : std::optional(found->second);
  }

  zmq::context_t& context_;
  KeyPair own_;
  std::mutex mutex_;
  std::map<std::string, std::string> roles_;  ///< by public key
  zmq::socket_t requests_, stop_here_, stop_there_;
  std::thread thread_;
};

KeyCheck::KeyCheck(zmq::context_t& context, const CouplerKeys& keys)
    : implementation_(std::make_unique<Implementation>(context, keys)) {}
KeyCheck::~KeyCheck() = default;
void KeyCheck::guard(zmq::socket_t& socket) const {
  implementation_->guard(socket);
}
void KeyCheck::prove() {
  implementation_->prove();
}

void use_keys(zmq::socket_t& socket, const ParticipantKeys& keys) {
  socket.set(zmq::sockopt::curve_serverkey, keys.coupler_public_key);
  socket.set(zmq::sockopt::curve_publickey, keys.own.public_key);
  socket.set(zmq::sockopt::curve_secretkey, keys.own.secret_key);
}

}  // namespace fissura
