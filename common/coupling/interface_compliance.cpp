// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/coupling/interface_compliance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/coupling/displacement_discontinuity.hpp"
#include "common/coupling/line_compliance.hpp"

namespace fissura {

namespace {

using Neighbours = std::vector<std::vector<std::size_t>>;

Neighbours neighbours_of(const FractureNetwork& network) {
  Neighbours neighbours(network.nodes().size());
  for (const NetworkSegment& segment : network.segments()) {
    const std::size_t a = network.index_of(segment.node_a), b = network.index_of(segment.node_b);
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  return neighbours;
}

std::vector<std::size_t> connected_part(const Neighbours& neighbours, std::size_t start, std::vector<bool>& seen) {
  std::vector<std::size_t> part{start};
  seen[start] = true;
  for (std::size_t k = 0; k < part.size(); ++k)
    for (const std::size_t next : neighbours[part[k]])
      if (!seen[next]) {
        seen[next] = true;
        part.push_back(next);
      }
  std::sort(part.begin(), part.end());
  return part;
}

struct Direction {
  double x = 0, y = 0;
};

Direction direction(const NetworkNode& from, const NetworkNode& to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

/// The part's nodes from one end to the other if it does not branch.
std::optional<std::vector<std::size_t>> chain_of(const Neighbours& neighbours, const std::vector<std::size_t>& part) {
  if (part.size() == 1) return part;
  std::optional<std::size_t> end;
  for (const std::size_t node : part) {
    if (neighbours[node].size() > 2) return std::nullopt;
    if (neighbours[node].size() == 1 && !end) end = node;
  }
  if (!end) return std::nullopt;
  std::vector<std::size_t> chain{*end};
  while (chain.size() < part.size()) {
    const std::size_t here = chain.back();
    for (const std::size_t next : neighbours[here])
      if (chain.size() < 2 || next != chain[chain.size() - 2]) {
        chain.push_back(next);
        break;
      }
  }
  return chain;
}

void closed_form(const FractureNetwork& network, const std::vector<std::size_t>& chain, double plane_strain_modulus,
                 std::vector<double>& compliance) {
  double trace = 0;
  for (const std::size_t node : chain) trace += network.nodes()[node].lumped_length;
  double begin = 0;
  for (const std::size_t node : chain) {
    const double cell = network.nodes()[node].lumped_length;
    compliance[node] = straight_crack_compliance(begin + cell / 2, trace, cell, plane_strain_modulus);
    begin += cell;
  }
}

/// Whether the row sum is well posed and cheap: a tree of few nodes. In a network that encloses blocks of rock the blocks
/// could move freely, so that the static opening of all of it together has no bound.
bool small_tree(const Neighbours& neighbours, const std::vector<std::size_t>& part) {
  std::size_t arms = 0;
  for (const std::size_t node : part) arms += neighbours[node].size();
  return part.size() <= most_nodes_of_row_sum && arms / 2 + 1 == part.size();
}

/// One element along the chord of an ordinary node; at a junction one per arm, half way to the neighbour.
void row_sum(const FractureNetwork& network, const Neighbours& neighbours, const std::vector<std::size_t>& part,
             double plane_strain_modulus, std::vector<double>& compliance) {
  const auto& nodes = network.nodes();
  std::vector<DiscontinuityElement> elements;
  std::vector<std::size_t> owner;
  for (const std::size_t node : part) {
    const NetworkNode& here = nodes[node];
    const auto& around = neighbours[node];
    if (around.size() <= 2) {
      const NetworkNode& before = nodes[around.front()];
      const Direction along = direction(before, around.size() == 2 ? nodes[around.back()] : here);
      elements.push_back({here.x, here.y, along.x, along.y, here.lumped_length / 2});
      owner.push_back(node);
      continue;
    }
    for (const std::size_t neighbour : around) {
      const Direction along = direction(here, nodes[neighbour]);
      const double arm = here.lumped_length / static_cast<double>(around.size());
      elements.push_back({here.x + along.x * arm / 2, here.y + along.y * arm / 2, along.x, along.y, arm / 2});
      owner.push_back(node);
    }
  }
  const std::vector<double> opening = opening_under_unit_pressure(elements, plane_strain_modulus);
  for (const std::size_t node : part) compliance[node] = 0;
  for (std::size_t k = 0; k < elements.size(); ++k)
    compliance[owner[k]] += opening[k] * 2 * elements[k].half_length / nodes[owner[k]].lumped_length;
}

}  // namespace

double compliance_floor(double cell, double plane_strain_modulus) { return 2 * cell / plane_strain_modulus; }

double straight_crack_compliance(double distance, double trace, double cell, double plane_strain_modulus) {
  const double product = std::max(distance * (trace - distance), cell * cell / 4);
  return 4 / plane_strain_modulus * std::sqrt(product);
}

std::vector<double> interface_compliance(const FractureNetwork& network, double plane_strain_modulus, double factor) {
  const Neighbours neighbours = neighbours_of(network);
  std::vector<double> compliance(network.nodes().size());
  std::vector<bool> seen(network.nodes().size(), false);
  std::vector<double> by_lines;
  for (std::size_t start = 0; start < network.nodes().size(); ++start) {
    if (seen[start]) continue;
    const std::vector<std::size_t> part = connected_part(neighbours, start, seen);
    double share = factor;
    if (const auto chain = chain_of(neighbours, part)) {
      closed_form(network, *chain, plane_strain_modulus, compliance);
    } else if (small_tree(neighbours, part)) {
      row_sum(network, neighbours, part, plane_strain_modulus, compliance);
    } else {
      if (by_lines.empty()) by_lines = line_compliance(network, plane_strain_modulus);
      for (const std::size_t node : part) compliance[node] = by_lines[node];
      share = std::max(factor, least_factor_of_lines);
    }
    for (const std::size_t node : part) compliance[node] *= share;
  }
  for (std::size_t i = 0; i < compliance.size(); ++i)
    compliance[i] = std::max(
        compliance[i], compliance_floor(network.nodes()[i].lumped_length, plane_strain_modulus));
  return compliance;
}

}  // namespace fissura
