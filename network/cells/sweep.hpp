// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "network/laws/carter_leak_off.hpp"

namespace fissura::cells {

/// When the faces of a cell were exposed: by a tip that swept them from `begin` to `end`
/// (docs/flow_solvers.md, 3.4), or at once, begin = end.
struct Sweep {
  double begin = 0;      ///< [s]
  double end = 0;        ///< infinite while the tip is in the cell [s]
  double residence = 0;  ///< of the tip in the cell before [s]
};

/// What both faces have to take up to `time`, per trace length [m].
double leak_off_of(const network::CarterLaw& law, const Sweep& sweep, double time);

/// The tip has entered `cell` at its sweep's begin, and has thereby passed the cells it came from.
/// @param neighbours  of `cell`
void enter(std::size_t cell, const std::vector<std::size_t>& neighbours, std::vector<Sweep>& sweeps);

}  // namespace fissura::cells
