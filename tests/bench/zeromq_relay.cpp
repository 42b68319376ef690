// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/zeromq_relay.hpp"

#include <string_view>
#include <vector>
#include <zmq.hpp>

#include "tests/bench/forked_peer.hpp"

namespace fissura::bench {

namespace {

/// `values` holds all arrays, one behind the other.
void send_arrays(zmq::socket_t& socket, const std::vector<double>& values, std::size_t arrays) {
  const std::size_t count = values.size() / arrays;
  for (std::size_t k = 0; k < arrays; ++k) {
    zmq::message_t frame(values.data() + k * count, count * sizeof(double));
    socket.send(frame, k + 1 == arrays ? zmq::send_flags::none : zmq::send_flags::sndmore);
  }
}

/// Values in each of the arrays received.
std::size_t receive_arrays(zmq::socket_t& socket) {
  zmq::message_t frame;
  do (void)socket.recv(frame);
  while (frame.more());
  return frame.size() / sizeof(double);
}

void answer(const std::string& endpoint, const std::string& role, std::size_t arrays) {
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  socket.set(zmq::sockopt::routing_id, role);
  socket.connect(endpoint);
  socket.send(zmq::message_t(), zmq::send_flags::none);
  std::vector<double> values;
  while (const std::size_t count = receive_arrays(socket)) {
    values.resize(arrays * count, 1.0);
    send_arrays(socket, values, arrays);
  }
}

}  // namespace

class ZeromqRelay::Implementation {
 public:
  explicit Implementation(const std::string& endpoint)
      : network_(forked_peer([&] { answer(endpoint, "network", pressure_arrays); })),
        structure_(forked_peer([&] { answer(endpoint, "structure", response_arrays); })),
        socket_(context_, zmq::socket_type::router) {
    socket_.bind(endpoint);
    for (int peer = 0; peer < 2; ++peer) receive_arrays(socket_);
  }

  ~Implementation() {
    for (const char* role : {"network", "structure"}) {
      socket_.send(zmq::buffer(std::string_view(role)), zmq::send_flags::sndmore);
      socket_.send(zmq::message_t(), zmq::send_flags::none);
    }
    for (coupler::ChildProcess* peer : {&network_, &structure_}) peer->wait_or_kill(1);
  }

  void set_values(std::size_t count) { values_.assign(advance_arrays * count, 1.0); }

  void step() {
    for (const char* role : {"network", "structure"}) {
      socket_.send(zmq::buffer(std::string_view(role)), zmq::send_flags::sndmore);
      send_arrays(socket_, values_, advance_arrays);
      receive_arrays(socket_);
    }
  }

 private:
  coupler::ChildProcess network_, structure_;
  zmq::context_t context_;
  zmq::socket_t socket_;
  std::vector<double> values_;
};

ZeromqRelay::ZeromqRelay(const std::string& endpoint)
    : implementation_(std::make_unique<Implementation>(endpoint)) {}
ZeromqRelay::~ZeromqRelay() = default;
void ZeromqRelay::set_values(std::size_t count) {
  implementation_->set_values(count);
}
void ZeromqRelay::step() {
  implementation_->step();
}

}  // namespace fissura::bench
