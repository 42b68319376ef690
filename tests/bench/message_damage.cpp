// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/message_damage.hpp"

#include <cstring>
#include <functional>
#include <limits>
#include <utility>

#include "common/fracture_network/insertion_json.hpp"
#include "tests/fuzz/sample_network.hpp"

namespace fissura::bench {

namespace {

using Bytes = std::vector<std::byte>;

double share(Random& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

Bytes& any_of(Random& random, fuzz::Frames& frames) {
  return frames[below(random, frames.size())];
}

void flip(Random& random, Bytes& frame) {
  if (!frame.empty()) frame[below(random, frame.size())] ^= std::byte(1 << below(random, 8));
}

void fill(Random& random, Array& array, double low, double high) {
  std::vector<double> values(array.bytes.size() / sizeof(double));
  for (double& value : values) value = low + (high - low) * share(random);
  if (!values.empty()) std::memcpy(array.bytes.data(), values.data(), array.bytes.size());
}

fuzz::Frames frames_of(const Sent& sent) {
  return fuzz::frames_of(encode(sent.message, sent.stamp));
}

Array* any_number_array(Random& random, Message& message) {
  std::vector<Array*> found;
  for (Array& array : message.arrays)
    if (array.dtype == "float64" && !array.bytes.empty()) found.push_back(&array);
  return found.empty() ? nullptr : found[below(random, found.size())];
}

void put(Array& array, std::size_t index, double value) {
  std::memcpy(array.bytes.data() + index * sizeof(double), &value, sizeof(double));
}

// Damage on the way: the checksum is the sender's.
using FrameFault = std::pair<const char*, std::function<void(Random&, fuzz::Frames&)>>;
const std::vector<FrameFault> frame_faults{
    {"one bit flipped", [](Random& random, fuzz::Frames& frames) { flip(random, any_of(random, frames)); }},
    {"bits flipped",
     [](Random& random, fuzz::Frames& frames) {
       for (std::size_t left = 2 + below(random, 63); left > 0; --left) flip(random, any_of(random, frames));
     }},
    {"bytes overwritten",
     [](Random& random, fuzz::Frames& frames) {
       Bytes& frame = any_of(random, frames);
       for (std::size_t left = below(random, 33); left > 0 && !frame.empty(); --left)
         frame[below(random, frame.size())] = std::byte(random() & 0xff);
     }},
    {"frame cut",
     [](Random& random, fuzz::Frames& frames) {
       Bytes& frame = any_of(random, frames);
       frame.resize(below(random, frame.size() + 1));
     }},
    {"frame longer",
     [](Random& random, fuzz::Frames& frames) {
       Bytes& frame = any_of(random, frames);
       frame.resize(frame.size() + 1 + below(random, 16), std::byte(random() & 0xff));
     }},
    {"frame missing",
     [](Random& random, fuzz::Frames& frames) {
       frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(below(random, frames.size())));
     }},
    {"frame twice",
     [](Random& random, fuzz::Frames& frames) {
       const Bytes copy = any_of(random, frames);
       frames.insert(frames.begin() + static_cast<std::ptrdiff_t>(below(random, frames.size() + 1)), copy);
     }},
    {"frames swapped",
     [](Random& random, fuzz::Frames& frames) { std::swap(any_of(random, frames), any_of(random, frames)); }},
    {"parts of a frame swapped",
     [](Random& random, fuzz::Frames& frames) {
       Bytes& frame = any_of(random, frames);
       if (frame.size() < 16) return;
       const auto words = frame.size() / 8;
       auto* first = frame.data();
       std::swap_ranges(first, first + 8, first + 8 * (1 + below(random, words - 1)));
     }},
};

// A sender that is wrong: the checksum fits what it sends.
using MessageFault = std::pair<const char*, std::function<void(Random&, Sent&)>>;
const std::vector<MessageFault> message_faults{
    {"of another run", [](Random& random, Sent& sent) { sent.stamp.run[below(random, 16)] ^= 1; }},
    {"of another epoch", [](Random& random, Sent& sent) { sent.stamp.epoch += static_cast<std::uint32_t>(1 + random() % 3); }},
    {"of another number", [](Random& random, Sent& sent) { sent.stamp.sequence += 1 + random() % 5; }},
    {"of an earlier number", [](Random&, Sent& sent) { sent.stamp.sequence -= 1; }},
    {"for another topology", [](Random& random, Sent& sent) { sent.message.revision += 1 + random() % 3; }},
    {"not a number",
     [](Random& random, Sent& sent) {
       const double poison[] = {std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};
       if (Array* array = any_number_array(random, sent.message))
         put(*array, below(random, array->bytes.size() / 8), poison[below(random, 3)]);
     }},
    {"of another length",
     [](Random& random, Sent& sent) {
       Array* array = any_number_array(random, sent.message);
       if (array == nullptr || array->shape.size() != 1) return;
       array->shape[0] += 1;
       array->bytes.resize(array->bytes.size() + 8);
     }},
    {"without an array",
     [](Random& random, Sent& sent) {
       if (!sent.message.arrays.empty())
         sent.message.arrays.erase(sent.message.arrays.begin() +
                                   static_cast<std::ptrdiff_t>(below(random, sent.message.arrays.size())));
     }},
};

}  // namespace

std::size_t below(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random() % count);
}

Message random_message(Random& random, const FractureNetwork& network) {
  switch (below(random, 4)) {
    case 0: {
      Message message = fuzz::pressure_message(network);
      fill(random, message.arrays[0], -1e6, 5e7);
      fill(random, message.arrays[1], 0, 1e-2);
      fill(random, message.arrays[2], 0, 1);
      message.body["well_pressure"] = 1e7 * share(random);
      return message;
    }
    case 1: {
      Message message = fuzz::response_message(network);
      fill(random, message.arrays[0], 0, 1e-2);
      fill(random, message.arrays[1], -1e-3, 1e-3);
      fill(random, message.arrays[2], 0, 5e7);
      message.body["energy"]["kinetic"] = share(random);
      return message;
    }
    case 2: {
      Message message(MessageType::insert);
      message.revision = network.revision();
      Insertion insertion = fuzz::growth(network.nodes().size());
      insertion.new_nodes[0].y = share(random);
      message.body["insertion"] = insertion_to_json(insertion);
      return message;
    }
    default: {
      Message message(MessageType::state);
      message.revision = network.revision();
      Bytes bytes(below(random, 2000));
      for (std::byte& byte : bytes) byte = std::byte(random() & 0xff);
      message.add_bytes("state", bytes);
      return message;
    }
  }
}

Damaged spoil(Random& random, const Sent& earlier, const Sent& sent, const Sent& later) {
  const std::size_t choice = below(random, frame_faults.size() + message_faults.size() + 3);
  if (choice < frame_faults.size()) {
    Damaged damaged{frame_faults[choice].first, frames_of(sent)};
    frame_faults[choice].second(random, damaged.frames);
    return damaged;
  }
  if (choice < frame_faults.size() + message_faults.size()) {
    const auto& [kind, fault] = message_faults[choice - frame_faults.size()];
    Sent other = sent;
    fault(random, other);
    return {kind, frames_of(other)};
  }
  switch (choice - frame_faults.size() - message_faults.size()) {
    case 0:
      return {"the one before, again", frames_of(earlier)};
    case 1:
      return {"the one after", frames_of(later)};
    default: {
      // A whole frame of another sound message.
      Damaged damaged{"frame of another message", frames_of(sent)};
      fuzz::Frames other = frames_of(later);
      damaged.frames[below(random, damaged.frames.size())] = any_of(random, other);
      return damaged;
    }
  }
}

}  // namespace fissura::bench
