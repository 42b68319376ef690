// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "common/errors.hpp"
#include "common/fracture_network/fracture_network.hpp"
#include "common/fracture_network/insertion_json.hpp"

using namespace fissura;

namespace {

Insertion first() {
  Insertion insertion;
  insertion.new_nodes = {{10, 0.0, 0.0, 0.5, 1, NodeRole::perforation, 0.0}, {11, 0.1, 0.0, 0.5, 1, NodeRole::tip, 0.0}};
  insertion.new_segments = {{20, 10, 11, 1, SegmentKind::hydraulic, 0.1}};
  insertion.new_perforations = {{"perforation", 10}};
  return insertion;
}

Insertion second() {
  Insertion insertion;
  insertion.revision = 1;
  insertion.updated_nodes = {{11, 0.1, 0.0, 0.7, 1, NodeRole::interior, 0.0}};
  insertion.new_nodes = {{12, 0.3, 1.0 / 3.0, 0.2, 1, NodeRole::tip, 0.25}};
  insertion.parents = {{12, 11}};
  insertion.new_segments = {{21, 11, 12, 1, SegmentKind::hydraulic, 0.38}};
  return insertion;
}

}  // namespace

TEST_CASE("an insertion appends nodes and keeps the order of the old ones", "[common][fracture_network]") {
  FractureNetwork network;
  network.apply(first());
  network.apply(second());
  CHECK(network.revision() == 1);
  REQUIRE(network.nodes().size() == 3);
  CHECK(network.index_of(10) == 0);
  CHECK(network.index_of(12) == 2);
  CHECK(network.nodes()[1].lumped_length == 0.7);
  CHECK(network.segments_at(1) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("a doubled, lost or early insertion is refused and changes nothing", "[common][fracture_network]") {
  FractureNetwork network;
  CHECK_THROWS_WITH(network.apply(second()), Catch::Contains("makes revision 1, expected revision 0"));
  network.apply(first());
  const std::string hash = network.topology_hash();
  CHECK_THROWS_AS(network.apply(first()), ProtocolError);
  Insertion late = second();
  late.revision = 2;
  CHECK_THROWS_AS(network.apply(late), ProtocolError);
  CHECK(network.topology_hash() == hash);
}

TEST_CASE("an insertion that does not fit is refused as a whole", "[common][fracture_network]") {
  FractureNetwork network;
  network.apply(first());
  const std::string hash = network.topology_hash();
  Insertion insertion = second();
  SECTION("an id that exists") { insertion.new_nodes[0].id = 10; }
  SECTION("a segment id that exists") { insertion.new_segments[0].id = 20; }
  SECTION("an unknown end") { insertion.new_segments[0].node_b = 99; }
  SECTION("an unknown parent") { insertion.parents[0].parent = 99; }
  SECTION("no length") { insertion.new_nodes[0].lumped_length = 0; }
  SECTION("a segment to remove that is not there") { insertion.removed_segments = {77}; }
  CHECK_THROWS_AS(network.apply(insertion), ProtocolError);
  CHECK(network.topology_hash() == hash);
}

TEST_CASE("the id of a removed segment is not used again", "[common][fracture_network]") {
  FractureNetwork network;
  network.apply(first());
  Insertion removal;
  removal.revision = 1;
  removal.removed_segments = {20};
  network.apply(removal);
  CHECK(network.segments().empty());
  Insertion again;
  again.revision = 2;
  again.new_segments = first().new_segments;
  CHECK_THROWS_AS(network.apply(again), ProtocolError);
}

TEST_CASE("the topology hash tells revision, ids, places and lengths apart", "[common][fracture_network]") {
  FractureNetwork network;
  network.apply(first());
  // Made by Python's hashlib from the layout of docs/protocol.md, section 4.
  CHECK(network.topology_hash() == "65555981bf04ff94fd20789a7dd0cd4d53ce9318c1bc3d1a9de9ad13c413ca3d");
  Insertion moved = first();
  moved.new_nodes[1].x = std::nextafter(0.1, 1.0);
  FractureNetwork other;
  other.apply(moved);
  CHECK(other.topology_hash() != network.topology_hash());
}

TEST_CASE("an insertion comes back from JSON with every bit", "[common][fracture_network]") {
  CHECK(insertion_from_json(nlohmann::json::parse(insertion_to_json(second()).dump())) == second());
  nlohmann::json broken = insertion_to_json(second());
  broken["new_nodes"][0]["role"] = 17;
  CHECK_THROWS_WITH(insertion_from_json(broken), Catch::Contains("role must lie in [0, 3], found 17"));
  broken["new_nodes"][0].erase("role");
  CHECK_THROWS_AS(insertion_from_json(broken), ProtocolError);
}

TEST_CASE("an id that is no whole number in range is refused, not rounded", "[common][fracture_network]") {
  const nlohmann::json sound = insertion_to_json(second());
  REQUIRE_NOTHROW(insertion_from_json(sound));
  for (const char* number : {"6.55556e+19", "2.7", "2.0", "-1", "1e300", "\"2\"", "null", "true"}) {
    INFO(number);
    nlohmann::json damaged = sound;
    damaged["new_nodes"][0]["id"] = nlohmann::json::parse(number);
    CHECK_THROWS_AS(insertion_from_json(damaged), ProtocolError);
    damaged = sound;
    damaged["removed_segments"] = {nlohmann::json::parse(number)};
    CHECK_THROWS_AS(insertion_from_json(damaged), ProtocolError);
    damaged = sound;
    damaged["revision"] = nlohmann::json::parse(number);
    CHECK_THROWS_AS(insertion_from_json(damaged), ProtocolError);
  }
}
