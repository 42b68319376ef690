// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura::structure {

/// What an element needs to know of a node.
struct alignas(32) NodeRecord {
  double x, y;    ///< [m]
  double ux, uy;  ///< [m]
};

}  // namespace fissura::structure
