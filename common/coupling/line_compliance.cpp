// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/coupling/line_compliance.hpp"

#include <algorithm>

#include "common/coupling/interface_compliance.hpp"
#include "common/coupling/trace_lines.hpp"

namespace fissura {

namespace {

/// A line on its way through a node.
struct Passage {
  std::size_t line = 0;
  double run = 0;  ///< longest way along the line from here [m]
};

using Passages = std::vector<std::vector<Passage>>;

Passages passages_of(const FractureNetwork& network, const std::vector<TraceLine>& lines) {
  Passages passages(network.nodes().size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    double position = 0;
    for (std::size_t i = 0; i < lines[k].nodes.size(); ++i) {
      if (i > 0) position += network.segments()[lines[k].segments[i - 1]].length;
      passages[lines[k].nodes[i]].push_back({k, std::max(position, lines[k].length - position)});
    }
  }
  return passages;
}

/// How much of the trace lies beyond the end of line `k` at `node`.
double beyond_end(const FractureNetwork& network, const std::vector<TraceLine>& lines,
                  const Passages& passages, std::size_t k, std::size_t node, std::size_t segment) {
  double run = 0;
  bool tip = true;
  for (const Passage& other : passages[node]) {
    if (other.line == k) continue;
    tip = false;
    run = std::max(run, other.run);
  }
  if (!tip) return std::min(run, lines[k].length) / 2;
  return std::max(0.0, network.nodes()[node].lumped_length - network.segments()[segment].length / 2);
}

}  // namespace

std::vector<double> line_compliance(const FractureNetwork& network, double plane_strain_modulus) {
  const std::vector<TraceLine> lines = trace_lines(network);
  const Passages passages = passages_of(network, lines);
  const auto& segments = network.segments();
  std::vector<double> weighted(network.nodes().size(), 0.0), weight(network.nodes().size(), 0.0);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const TraceLine& line = lines[k];
    const bool ring = line.ring();
    const double before =
        ring ? 0 : beyond_end(network, lines, passages, k, line.nodes.front(), line.segments.front());
    const double after =
        ring ? 0 : beyond_end(network, lines, passages, k, line.nodes.back(), line.segments.back());
    const double trace = before + line.length + after;
    double distance = before;
    for (std::size_t i = 0; i < line.nodes.size(); ++i) {
      double arm = 0;
      if (i > 0) {
        distance += segments[line.segments[i - 1]].length;
        arm += segments[line.segments[i - 1]].length / 2;
      }
      if (i < line.segments.size()) arm += segments[line.segments[i]].length / 2;
      const std::size_t node = line.nodes[i];
      weight[node] += arm;
      weighted[node] +=
          arm * straight_crack_compliance(ring ? trace / 2 : distance, trace,
                                          network.nodes()[node].lumped_length, plane_strain_modulus);
    }
  }
  for (std::size_t i = 0; i < weighted.size(); ++i)
    if (weight[i] > 0) weighted[i] /= weight[i];
  return weighted;
}

}  // namespace fissura
