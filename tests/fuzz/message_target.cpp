// SPDX-License-Identifier: GPL-3.0-or-later
// Frames as they come from a socket: decoded, and if that succeeds read by all who read messages.
#include "common/fracture_network/insertion_json.hpp"
#include "common/seismicity/source_record.hpp"
#include "coupler/scheme/exchange.hpp"
#include "tests/fuzz/judged.hpp"
#include "tests/fuzz/raw_frames.hpp"
#include "tests/fuzz/sample_network.hpp"

using namespace fissura;

namespace {

void use_accessors(const Message& message) {
  for (const Array& array : message.arrays) {
    fuzz::take_or_refuse([&] { (void)message.numbers(array.name); });
    fuzz::take_or_refuse([&] { (void)message.ids(array.name); });
    fuzz::take_or_refuse([&] { (void)message.bytes(array.name); });
  }
  fuzz::take_or_refuse([&] { (void)message.value<std::string>("reason"); });
  fuzz::take_or_refuse([&] { (void)message.value<double>("coupler_deadline"); });
  fuzz::take_or_refuse([&] { (void)message.value<int>("exit_code"); });
}

void use_readers(const Message& message) {
  static const FractureNetwork network = fuzz::network_of(fuzz::first_insertion(3));
  fuzz::take_or_refuse([&] { (void)coupler::read_response(message, network, fuzz::pressure_range()); });
  fuzz::take_or_refuse([&] { (void)coupler::read_pressure(message, network, fuzz::pressure_range()); });
  fuzz::take_or_refuse([&] { (void)coupler::read_remeshing(message); });
  fuzz::take_or_refuse([&] { (void)coupler::read_meetings(message); });
  fuzz::take_or_refuse([&] { (void)records_of(message.arrays); });
  fuzz::take_or_refuse([&] {
    FractureNetwork next = network;
    next.apply(insertion_from_json(message.value<nlohmann::json>("insertion")));
  });
}

void require_same(const Message& one, const Message& other) {
  MUST_HOLD(one.type == other.type && one.interval == other.interval && one.revision == other.revision);
  MUST_HOLD(one.arrays.size() == other.arrays.size());
  for (std::size_t i = 0; i < one.arrays.size(); ++i)
    MUST_HOLD(one.arrays[i].name == other.arrays[i].name && one.arrays[i].bytes == other.arrays[i].bytes &&
              one.arrays[i].shape == other.arrays[i].shape);
}

void receive(const fuzz::Frames& frames) {
  const DecodedMessage decoded = fuzz::decode(frames);
  use_accessors(decoded.message);
  use_readers(decoded.message);
  const DecodedMessage again = fuzz::decode(fuzz::frames_of(encode(decoded.message, decoded.stamp)));
  require_same(decoded.message, again.message);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::Frames frames = fuzz::frames_of(fuzz::bytes_of(data, size));
  fuzz::take_or_refuse([&] { receive(frames); });
  fuzz::take_or_refuse([&] { receive(fuzz::restamped(frames)); });
  return 0;
}
