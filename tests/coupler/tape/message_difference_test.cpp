// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "common/exchange/codec.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/tape/meaningless_differences.hpp"
#include "coupler/tape/message_difference.hpp"
#include "coupler/tape/network_places.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

Frames frames_of(Message message) {
  const EncodedMessage encoded = encode(std::move(message), {});
  Frames frames;
  for (const auto& frame : fissura::frames_of(encoded)) frames.emplace_back(frame.begin(), frame.end());
  return frames;
}

Message answer() {
  Message message(MessageType::pressure);
  message.interval = 17;
  message.revision = 3;
  message.body = {{"ledger", {{"leaked", 0.125}, {"injected", 2.0}}}, {"newton", {{"iterations", 4}}}};
  message.add("pressure", "Pa", std::vector<double>{1e6, 2e6, 3e6});
  message.add("moment", "N m", std::vector<double>{1, 2, 3, 4, 5, 6}, 3, 2);
  return message;
}

void set(Message& message, std::size_t array, std::size_t index, double value) {
  const auto bytes = std::bit_cast<std::array<std::byte, 8>>(value);
  std::copy(bytes.begin(), bytes.end(), message.arrays[array].bytes.begin() + 8 * index);
}

}  // namespace

TEST_CASE("messages that differ in run, epoch and sequence only are equal", "[coupler][tape]") {
  const EncodedMessage encoded = encode(answer(), {{9}, 4, 77});
  Frames other;
  for (const auto& frame : fissura::frames_of(encoded)) other.emplace_back(frame.begin(), frame.end());
  CHECK_FALSE(difference(frames_of(answer()), other));
}

TEST_CASE("the first value of an array that differs is named with both values and their distance",
          "[coupler][tape]") {
  Message other = answer();
  set(other, 0, 1, std::nextafter(2e6, 3e6));
  set(other, 0, 2, 5e6);
  set(other, 1, 3, -4);
  const auto found = difference(frames_of(answer()), frames_of(other));
  REQUIRE(found);
  CHECK(found->where == "pressure[1]");
  CHECK(found->first == "2000000");
  CHECK(found->second == "2000000.0000000002");
  CHECK(found->ulps == 1);
  CHECK(found->values == 2);
  CHECK(found->places == 2);
  CHECK(found->row == 1);
  other = answer();
  set(other, 1, 3, -4);
  CHECK(difference(frames_of(answer()), frames_of(other))->where == "moment[1, 1]");
}

TEST_CASE("entries of the body, envelope and declarations are compared too", "[coupler][tape]") {
  const auto where = [](const Message& other) {
    const auto found = difference(frames_of(answer()), frames_of(other));
    return found ? found->where : std::string();
  };
  Message other = answer();
  other.body["ledger"]["leaked"] = std::nextafter(0.125, 1.0);
  CHECK(where(other) == "/ledger/leaked");
  other = answer();
  other.body["ledger"].erase("leaked");
  CHECK(where(other) == "/ledger/leaked");
  other = answer();
  other.body["more"] = true;
  CHECK(where(other) == "/more");
  other = answer();
  other.interval = 18;
  CHECK(where(other) == "interval");
  other = answer();
  other.type = MessageType::response;
  CHECK(where(other) == "type");
  other = answer();
  other.arrays[1].unit = "J";
  CHECK(where(other) == "array 2");
  other = answer();
  other.arrays.pop_back();
  CHECK(where(other) == "array 2");
  other = answer();
  set(other, 0, 0, -0.0);
  Message zero = answer();
  set(zero, 0, 0, 0.0);
  CHECK(difference(frames_of(zero), frames_of(other)));
}

TEST_CASE("only what depends on process, run or wall time may differ", "[coupler][tape]") {
  Message hello(MessageType::hello);
  hello.body = {{"role", "network"}, {"pid", 1}, {"capabilities", {"save"}}};
  Message other = hello;
  other.body["pid"] = 2;
  other.body["capabilities"] = {"save", "restore"};
  CHECK_FALSE(difference(frames_of(hello), frames_of(other)));
  other.body["role"] = "structure";
  CHECK(difference(frames_of(hello), frames_of(other))->where == "/role");
  CHECK(is_meaningless(MessageType::acknowledge, "/remeshing/12/wall_seconds"));
  CHECK_FALSE(is_meaningless(MessageType::acknowledge, "/remeshing/12/mass_error"));
  CHECK(is_meaningless(MessageType::bye, "/figures/work_seconds"));
  CHECK_FALSE(is_meaningless(MessageType::bye, "/figures/elements"));
  for (const MeaninglessDifference& each : meaningless_differences()) CHECK_FALSE(each.reason.empty());
}

TEST_CASE("the distance of two numbers counts the doubles between them", "[coupler][tape]") {
  CHECK(ulps_between(1, 1) == 0);
  CHECK(ulps_between(1, std::nextafter(1.0, 2.0)) == 1);
  CHECK(ulps_between(-1, std::nextafter(-1.0, -2.0)) == 1);
  CHECK(ulps_between(-0.0, 0.0) == 1);
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(ulps_between(-least, least) == 3);
  CHECK(ulps_between(1, 2) == std::uint64_t{1} << 52);
}

TEST_CASE("a row of an array is the node or segment of the insertions so far", "[coupler][tape]") {
  Insertion insertion;
  insertion.new_nodes = {
      {40, 1.25, 0, 1, 0, NodeRole::tip, 0}, {41, 2.5, 0.5, 1, 0, NodeRole::tip, 0}, {42, 3, 1, 1}};
  insertion.new_segments = {{7, 40, 41, 0, SegmentKind::hydraulic, 1.5},
                            {8, 41, 42, 0, SegmentKind::hydraulic, 1}};
  Message command(MessageType::insert);
  command.body = {{"insertion", insertion_to_json(insertion)}};
  NetworkPlaces places;
  places.follow(frames_of(std::move(command)));
  Message advance(MessageType::advance);
  advance.add("aperture", "m", std::vector<double>{1, 2, 3});
  advance.add("arm_aperture_a", "m", std::vector<double>{1, 2});
  advance.add("other", "m", std::vector<double>{1, 2, 3, 4});
  const Frames frames = frames_of(std::move(advance));
  CHECK(places.place(frames, "aperture", 1) == "node 41 at (2.5, 0.5) m");
  CHECK(places.place(frames, "arm_aperture_a", 1) == "segment 8 between nodes 41 and 42");
  CHECK(places.place(frames, "other", 1).empty());
}
