// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "coupler/conformance/balance.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/physics_checks.hpp"
#include "coupler/conformance/still_rock.hpp"
#include "coupler/conformance/topologies.hpp"

// Where the fluid is after an insertion: seen in an interval that is too short for anything to flow.
namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 5";
constexpr std::size_t nodes = 9;
constexpr double spacing = 0.5, pumping = 0.02, rate = 4e-5;
/// What flows in it is a millionth of what a node holds.
constexpr double instant = 1e-9;
/// Of a node's content: what flows in the instant, and what was left of differences.
constexpr double moved = 1e-5;

using MakeInsertion = std::function<Insertion(const FractureNetwork&, double time)>;

std::vector<double> lengths_of(const FractureNetwork& network) {
  std::vector<double> lengths;
  for (const NetworkNode& node : network.nodes()) lengths.push_back(node.lumped_length);
  return lengths;
}

/// A slit of apertures that differ is brought to rest and changed by `make`; every node is wider afterwards,
/// so that `filled` tells its content.
struct Moved {
  Moved(const Candidate& candidate, const MakeInsertion& make)
      : scene(candidate, puff(rate, pumping), straight_slit(nodes, spacing, nodes / 2), {.aperture = 1e-4}) {
    for (std::size_t i = 0; i < nodes; ++i) scene.asked.aperture[i] *= 1 + 0.1 * static_cast<double>(i);
    scene.advance(pumping);
    scene.come_to_rest(1e-4);
    before = content_of(scene.last, water::bulk_modulus);
    old_length = lengths_of(scene.driver.network());
    scene.insert(make(scene.driver.network(), scene.time));
    length = lengths_of(scene.driver.network());
    scene.asked.aperture.assign(length.size(), 5e-4);
    scene.advance(instant);
    after = content_of(scene.last, water::bulk_modulus);
    require_balance(scene.driver, scene.last);
  }

  StillScene scene;
  std::vector<double> before, old_length, after, length;  ///< contents of nodes and what they stand for [m]
};

void require_content(const Moved& fluid, std::size_t node, double expected) {
  require_close(fmt::format("content of node {} after the insertion [m]", node), fluid.after[node], expected,
                moved * fluid.before.front());
}

/// Old nodes keep l m, new ones have none.
std::string stays(const Candidate& candidate, const MakeInsertion& make) {
  const Moved fluid(candidate, make);
  for (std::size_t i = 0; i < nodes; ++i)
    require_content(fluid, i, fluid.before[i] * fluid.old_length[i] / fluid.length[i]);
  for (std::size_t i = nodes; i < fluid.after.size(); ++i) require_content(fluid, i, 0);
  return fmt::format("every old node has its fluid, {} new ones have none", fluid.after.size() - nodes);
}

std::string growth(const Candidate& candidate) {
  return stays(candidate, [](const FractureNetwork& network, double time) {
    return tip_growth(network, spacing, time);
  });
}

std::string arm(const Candidate& candidate) {
  return stays(candidate, [](const FractureNetwork& network, double time) {
    return junction(network, 2, 2, spacing, time);
  });
}

std::string several(const Candidate& candidate) {
  return stays(candidate, [](const FractureNetwork& network, double time) {
    return several_at_once(network, 6, spacing, time);
  });
}

std::string shortened(const Candidate& candidate) {
  return stays(candidate, [](const FractureNetwork& network, double) {
    Insertion insertion;
    insertion.revision = network.revision() + 1;
    insertion.updated_nodes = {network.nodes()[3]};
    insertion.updated_nodes.front().lumped_length *= 0.7;
    return insertion;
  });
}

std::string split(const Candidate& candidate) {
  constexpr std::size_t west = 2, east = 3;
  const Moved fluid(candidate, [](const FractureNetwork& network, double time) {
    return split_segment(network, west, time);
  });
  for (std::size_t i = 0; i < nodes; ++i) require_content(fluid, i, fluid.before[i]);
  const double given = (fluid.old_length[west] - fluid.length[west]) * fluid.before[west] +
                       (fluid.old_length[east] - fluid.length[east]) * fluid.before[east];
  require_content(fluid, nodes, given / fluid.length[nodes]);
  return fmt::format("{:.6g} m in the new node, {:.6g} m by hand", fluid.after[nodes],
                     given / fluid.length[nodes]);
}

}  // namespace

std::vector<Check> transfer_checks() {
  const std::set<std::string> flow{claims::viscous_flow}, growing{"insert"};
  return {
      {.name = "transfer.growth",
       .contract = contract,
       .expected = "a tip that grows spreads its fluid over its new length, the new node has none",
       .physics = flow,
       .capabilities = growing,
       .carry_out = growth},
      {.name = "transfer.arm",
       .contract = contract,
       .expected = "so does a node from which an arm starts",
       .physics = flow,
       .capabilities = growing,
       .carry_out = arm},
      {.name = "transfer.several",
       .contract = contract,
       .expected = "and several at once, each for itself",
       .physics = flow,
       .capabilities = growing,
       .carry_out = several},
      {.name = "transfer.shortened",
       .contract = contract,
       .expected = "a node shortened without a new one beside it keeps its fluid, which rises",
       .physics = flow,
       .capabilities = growing,
       .carry_out = shortened},
      {.name = "transfer.split",
       .contract = contract,
       .expected =
           "the ends of a split segment give the fluid on the length that they lose, and keep their m",
       .physics = flow,
       .capabilities = growing,
       .carry_out = split},
  };
}

}  // namespace fissura::coupler::conformance
