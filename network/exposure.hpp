// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "network/graph.hpp"
#include "network/laws/carter_leak_off.hpp"

/// When the faces of a node's cell were exposed to the fluid. A hydraulic fracture's cell is swept by its
/// tip: from the release of the node to the release of the next one. A natural fracture's cell is swept by
/// the injected fluid: from the wetting of the node to that of its neighbour (network/wetting.hpp). Other
/// cells of revision 0 are exposed at once.
namespace fissura::network {

enum class Front : std::uint8_t {
  ahead = 0,   ///< natural fracture that no injected fluid has reached
  inside = 1,  ///< the front is sweeping the cell
  passed = 2
};

struct Exposure {
  double begin = 0;      ///< t_a [s]
  double end = 0;        ///< t_b [s], once the front has passed
  double residence = 0;  ///< time the front spent in the cell before this one [s]
  Front front = Front::passed;
};

/// Demand of both faces up to `time`, per trace length and thickness [m]. While the front is inside, t_b is
/// the later of `time` and begin + residence: the front is taken to need as long as it did for the cell
/// before.
double leak_off_demand(const CarterLaw& law, const Exposure& exposure, double time);

/// The front enters the cell of `node` at `time` and has thereby passed the cells it came from.
void expose(const Graph& graph, std::size_t node, double time, std::vector<Exposure>& exposures);

/// Ends the sweep of `node` at `time`: nothing lies ahead of it.
void end_sweep(std::size_t node, double time, std::vector<Exposure>& exposures);

/// Whether a natural fracture goes on from `node` into cells that no fluid has reached.
bool leads_ahead(const Graph& graph, std::size_t node, const std::vector<Exposure>& exposures);

}  // namespace fissura::network
