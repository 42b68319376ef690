// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "common/case/case.hpp"
#include "common/fracture_network/fracture_network.hpp"

namespace fissura::coupler {

/// Where a fracture went that was not there at the start. The slit is the open line of the case that holds
/// the first perforation; in a dry case the first open line. Grown are the hydraulic segments that lie on no
/// open line. A wing is the chain of grown segments that begins at an end of the slit; where it forks it
/// follows the segment that turns least.
struct FracturePath {
  std::vector<std::size_t> grown;  ///< indices into network.segments(), ascending
  std::vector<std::size_t> nodes;  ///< at grown segments, indices into network.nodes(), ascending
  /// Greatest distance of a wing's nodes from the straight line through the ends of the slit [m].
  double deviation = 0;
  /// Greatest over the wings: between the slit, outwards, and the chord from slit end to tip [rad].
  double chord_angle = 0;
  /// Greatest over the wings: of the first segment against the axis of greatest compression [rad].
  double first_angle = 0;
  /// The same of the chord over the last three segments [rad].
  double end_angle = 0;
};

/// The path in `network`; all zero without an open line or grown segments. Where the horizontal in-situ
/// stress is isotropic the slit takes the place of the axis of greatest compression.
FracturePath fracture_path(const FractureNetwork& network, const Case& run_case);

/// Trace length for which the joints at the grown segments have been pulled apart: the lumped length of their
/// nodes that are fully broken, and half of that of the others that are opened [m].
/// @param opened, broken  one value per node, > 0 for marked
double grown_length(const FractureNetwork& network, const FracturePath& path,
                    const std::vector<double>& opened, const std::vector<double>& broken);

}  // namespace fissura::coupler
