// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coupler/report/view.hpp"

namespace fissura::coupler {

/// A field of the plane on square cells, made to be drawn.
struct Raster {
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;  ///< at the middles of the cells, from the south-west corner to the east, row
                               ///< by row; NaN outside the mesh
};

/// Columns and rows of square cells in `view`, about `most_cells` of them.
Raster empty_raster(const View& view, std::size_t most_cells);

/// The mean over the elements at each node, weighted with their areas: what is constant in the elements
/// becomes linear in them. Faces of a fracture have nodes of their own, so that nothing is averaged across
/// it.
/// @param position  x and y of the nodes in turn [m] @param elements  three node indices each
std::vector<double> at_nodes(const std::vector<double>& position, const std::vector<double>& elements,
                             const std::vector<double>& of_elements);

/// A nodal field, linear in each element, on the cells of `raster`, which fill `view`.
Raster rasterised(const std::vector<double>& position, const std::vector<double>& elements,
                  const std::vector<double>& of_nodes, const View& view, Raster raster);

/// The values as bytes in base64: 0 at `low` to 254 at `high`, beyond them cut off, 255 for NaN. @pre low <
/// high
std::string as_bytes(const std::vector<double>& values, double low, double high);

}  // namespace fissura::coupler
