// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/fracture_extent.hpp"

#include <catch2/catch.hpp>

#include "tests/coupler/scheme/chain.hpp"

using namespace fissura;
using namespace fissura::coupler;
using fissura::coupler::test::chain_network;

TEST_CASE("the half length is half the trace, at any inclination", "[coupler][scheme]") {
  CHECK(half_length(chain_network(9, 0.5, 0)) == Approx(2).epsilon(1e-14));
  CHECK(half_length(chain_network(9, 0.5, 0.7)) == Approx(2).epsilon(1e-14));
}

TEST_CASE("a segment counts only if both of its nodes are marked", "[coupler][scheme]") {
  const FractureNetwork network = chain_network(5, 1, 0);
  CHECK(marked_half_length(network, {0, 1, 1, 1, 0}) == 1);
  CHECK(marked_half_length(network, {1, 0, 1, 0, 1}) == 0);
  CHECK(marked_half_length(network, {0, 0, 0, 0, 0}) == 0);
  CHECK(marked_half_length(network, {1, 1, 1, 1, 1}) == half_length(network));
}

TEST_CASE("a natural fracture that was met does not lengthen the hydraulic one", "[coupler][scheme]") {
  Insertion insertion = test::chain(5, 1, 0);
  insertion.new_segments.back().kind = SegmentKind::natural;
  FractureNetwork network;
  network.apply(insertion);
  CHECK(half_length(network) == 1.5);
  CHECK(marked_half_length(network, {0, 0, 0, 1, 1}) == 0);
}
