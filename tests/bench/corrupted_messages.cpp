// SPDX-License-Identifier: GPL-3.0-or-later
// corrupted_messages [COUNT [SEED]]: how many of COUNT (100 000) damaged messages change a value that coupler
// or participant goes on with.
//
// Each is one message of a sound conversation, spoiled on its way (bits, bytes, frames) or sent wrong under a
// right checksum (stamps, numbers, lengths), or another message in its place. The receiver is the real one:
// decoder, check of stamps, readers with their ranges. What is refused is counted by kind; what is accepted
// must be what was sent, value for value. Every two-hundredth also goes over a real socket into a real
// channel, of the coupler or of a participant. The exit code is 1 if a value changed unseen.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <zmq.hpp>

#include "common/byte_archive.hpp"
#include "common/errors.hpp"
#include "common/exchange/channel.hpp"
#include "common/exchange/stamp_check.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/scheme/exchange.hpp"
#include "tests/bench/message_damage.hpp"
#include "tests/fuzz/sample_network.hpp"

using namespace fissura;
using bench::Sent;

namespace {

constexpr std::size_t one_in_sockets = 200;
constexpr Seconds patience{2.0};
constexpr std::uint32_t epoch = 3;
const RunId run{9, 8, 7, 6, 5, 4, 3, 2, 1};

/// Every value that is used of a message, as bytes. Throws Error if a reader refuses it.
std::vector<std::byte> used_values(const Message& message, const FractureNetwork& network) {
  ByteWriter values;
  values.put(message.type);
  switch (message.type) {
    case MessageType::pressure: {
      const auto answer = coupler::read_pressure(message, network, fuzz::pressure_range());
      for (const auto& list : {answer.pressure, answer.aperture_predicted, answer.filled}) values.put(list);
      values.put(answer.ledger);
      values.put(std::vector<double>{answer.well_pressure, answer.rate});
      values.put(std::vector<int>{answer.newton_iterations, answer.halvings});
      break;
    }
    case MessageType::response: {
      const auto response = coupler::read_response(message, network, fuzz::pressure_range());
      for (const auto& list : {response.aperture, response.aperture_rate, response.pressure_applied,
                               response.pressure_opening, response.closed, response.broken})
        values.put(list);
      values.put(std::vector<double>{response.stable_step, response.mass_scale, response.kinetic_energy,
                                     response.strain_energy.value_or(-1)});
      values.put(response.elements);
      values.put(response.proposal ? insertion_to_json(*response.proposal).dump() : std::string());
      for (const Array& array : arrays_of(response.sources)) values.put(array.bytes);
      break;
    }
    case MessageType::insert: {
      const Insertion insertion = insertion_from_json(message.value<nlohmann::json>("insertion"));
      if (message.revision != network.revision()) throw ProtocolError("made for another topology");
      FractureNetwork next = network;
      next.apply(insertion);
      values.put(insertion_to_json(insertion).dump());
      values.put(next.topology_hash());
      break;
    }
    case MessageType::state:
      if (message.revision != network.revision()) throw ProtocolError("made for another topology");
      values.put(message.bytes("state"));
      break;
    default:
      throw ProtocolError("no message of this conversation");
  }
  return values.take();
}

/// The conversation so far was HELLO or WELCOME, number 0.
StampCheck check_after_handshake() {
  StampCheck check;
  check.check({run, epoch, 0}, Message(MessageType::hello), run, epoch);
  return check;
}

struct Outcome {
  bool refused = false;
  std::vector<std::byte> values;
};

Outcome received(const fuzz::Frames& frames, const FractureNetwork& network) {
  try {
    StampCheck check = check_after_handshake();
    const DecodedMessage decoded = fuzz::decode(frames);
    check.check(decoded.stamp, decoded.message, run, epoch);
    return {false, used_values(decoded.message, network)};
  } catch (const Error&) {
    return {true, {}};
  }
}

void send_frames(zmq::socket_t& socket, const fuzz::Frames& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i)
    socket.send(zmq::buffer(frames[i].data(), frames[i].size()),
                i + 1 < frames.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
}

fuzz::Frames handshake(MessageType type) {
  return fuzz::frames_of(encode(Message(type), {run, epoch, 0}));
}

/// Both ends of a connection, one of them bare, for one message after the handshake.
class Connection {
 public:
  explicit Connection(const std::string& endpoint) : endpoint_(endpoint) {}

  Outcome to_coupler(const fuzz::Frames& frames, const FractureNetwork& network) {
    CouplerChannel coupler(endpoint_, run, epoch);
    zmq::context_t context;
    zmq::socket_t participant(context, zmq::socket_type::dealer);
    participant.set(zmq::sockopt::linger, 0);
    participant.connect(endpoint_);
    send_frames(participant, handshake(MessageType::hello));
    const auto deadline = std::chrono::steady_clock::now() + patience;
    bool greeted = false;
    while (std::chrono::steady_clock::now() < deadline) {
      CouplerChannel::Event event = coupler.wait(Seconds(0.05), {});
      if (std::holds_alternative<CouplerChannel::PeerFault>(event) ||
          std::holds_alternative<CouplerChannel::PeerLost>(event))
        return {true, {}};
      auto* arrived = std::get_if<CouplerChannel::Received>(&event);
      if (arrived == nullptr) continue;
      if (greeted) return read(arrived->message, network);
      greeted = true;
      send_frames(participant, frames);
    }
    return {true, {}};
  }

  Outcome to_participant(const fuzz::Frames& frames, const FractureNetwork& network) {
    zmq::context_t context;
    zmq::socket_t coupler(context, zmq::socket_type::router);
    coupler.set(zmq::sockopt::linger, 0);
    coupler.set(zmq::sockopt::rcvtimeo, static_cast<int>(patience.count() * 1000));
    coupler.bind(endpoint_);
    ParticipantChannel participant(endpoint_);
    participant.send(Message(MessageType::hello));
    zmq::message_t identity, frame;
    if (!coupler.recv(identity)) throw Error(ExitCode::internal, "no HELLO came");
    for (bool more = true; more; more = frame.more())
      if (!coupler.recv(frame)) throw Error(ExitCode::internal, "no HELLO came");
    for (const fuzz::Frames& message : {handshake(MessageType::welcome), frames}) {
      coupler.send(zmq::buffer(identity.data(), identity.size()), zmq::send_flags::sndmore);
      send_frames(coupler, message);
    }
    try {
      for (bool greeted = false;; greeted = true) {
        auto event = participant.receive(patience);
        const Message* message = std::get_if<Message>(&event);
        if (message == nullptr) return {true, {}};
        if (greeted) return read(*message, network);
      }
    } catch (const Error&) {
      return {true, {}};
    }
  }

 private:
  static Outcome read(const Message& message, const FractureNetwork& network) {
    try {
      return {false, used_values(message, network)};
    } catch (const Error&) {
      return {true, {}};
    }
  }

  std::string endpoint_;
};

struct Count {
  std::size_t refused = 0, unchanged = 0, changed = 0;

  void add(const Outcome& outcome, const std::vector<std::byte>& sent) {
    ++(outcome.refused ? refused : outcome.values == sent ? unchanged : changed);
  }
};

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
  bench::Random random(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  std::string folder = (std::filesystem::temp_directory_path() / "fissura-damage-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return 1;
  Connection connection("ipc://" + folder + "/socket");

  std::map<std::string, Count> counts;
  Count over_sockets, all;
  for (std::size_t i = 0; i < count; ++i) {
    const FractureNetwork network = fuzz::network_of(fuzz::first_insertion(3 + bench::below(random, 40)));
    const Sent earlier{bench::random_message(random, network), {run, epoch, 0}},
        sent{bench::random_message(random, network), {run, epoch, 1}},
        later{bench::random_message(random, network), {run, epoch, 2}};
    const std::vector<std::byte> values = used_values(sent.message, network);
    const fuzz::Frames sound = fuzz::frames_of(encode(sent.message, sent.stamp));
    bench::Damaged damaged;
    do damaged = bench::spoil(random, earlier, sent, later);
    while (damaged.frames == sound);
    const Outcome outcome = received(damaged.frames, network);
    counts[damaged.kind].add(outcome, values);
    all.add(outcome, values);
    // An empty list of frames is no message to a socket.
    if (i % one_in_sockets != 0 || damaged.frames.empty()) continue;
    over_sockets.add(i / one_in_sockets % 2 == 0 ? connection.to_coupler(damaged.frames, network)
                                                 : connection.to_participant(damaged.frames, network),
                     values);
  }
  std::filesystem::remove_all(folder);

  fmt::print("{:<28} {:>8} {:>10} {:>8}\n", "", "refused", "unchanged", "CHANGED");
  const auto print = [](const std::string& kind, const Count& line) {
    fmt::print("{:<28} {:>8} {:>10} {:>8}\n", kind, line.refused, line.unchanged, line.changed);
  };
  for (const auto& [kind, line] : counts) print(kind, line);
  print("all", all);
  print("of these also over sockets", over_sockets);
  return all.changed + over_sockets.changed == 0 ? 0 : 1;
}
