// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/topologies.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace fissura;
using namespace fissura::coupler::conformance;

namespace {

/// Lumped lengths against half of every adjoining segment.
void require_lengths_fit(const FractureNetwork& network) {
  for (std::size_t i = 0; i < network.nodes().size(); ++i) {
    CAPTURE(i);
    double half = 0;
    for (const std::size_t s : network.segments_at(i)) half += network.segments()[s].length / 2;
    CHECK(network.nodes()[i].lumped_length == Approx(half).epsilon(1e-14));
  }
}

FractureNetwork slit() {
  FractureNetwork network;
  network.apply(straight_slit(9, 0.5, 4));
  return network;
}

}  // namespace

TEST_CASE("topologies: a node stands for half of every adjoining segment, before and after an insertion",
          "[coupler][conformance]") {
  for (const auto& insertion :
       {tip_growth(slit(), 0.5, 1), junction(slit(), 2, 3, 0.5, 1), several_at_once(slit(), 6, 0.5, 1),
        split_segment(slit(), 5, 1), natural_branch(slit(), 2, 3, 0.5, 1e6, 1e-11, 1)}) {
    FractureNetwork network = slit();
    require_lengths_fit(network);
    network.apply(insertion);
    CHECK(network.revision() == 1);
    require_lengths_fit(network);
  }
}

TEST_CASE("topologies: growth goes on from what was grown", "[coupler][conformance]") {
  FractureNetwork network = slit();
  for (int k = 0; k < 3; ++k) network.apply(tip_growth(network, 0.5, k));
  network.apply(split_segment(network, 0, 4));
  network.apply(several_at_once(network, 2, 0.5, 5));
  require_lengths_fit(network);
  CHECK(network.nodes().size() == 9 + 3 + 1 + 4);
  CHECK(network.nodes()[11].x == Approx(3.5));
}

TEST_CASE("topologies: an id is neither the index of its node nor in its order", "[coupler][conformance]") {
  const FractureNetwork network = slit();
  for (std::size_t i = 0; i < network.nodes().size(); ++i) {
    CHECK(network.nodes()[i].id > network.nodes().size());
    if (i > 0) CHECK(network.nodes()[i].id < network.nodes()[i - 1].id);
  }
}

TEST_CASE("topologies: ids stay apart in networks of many nodes", "[coupler][conformance]") {
  FractureNetwork network;
  CHECK_NOTHROW(network.apply(straight_slit(3000, 0.01, 1500)));
  std::set<NodeId> ids;
  for (const NetworkNode& node : network.nodes()) CHECK(ids.insert(node.id).second);
}
