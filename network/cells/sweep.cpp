// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/cells/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fissura::cells {

double leak_off_of(const network::CarterLaw& law, const Sweep& sweep, double time) {
  const double end = std::isinf(sweep.end) ? std::max(time, sweep.begin + sweep.residence) : sweep.end;
  return network::cell_leak_off(law, sweep.begin, end, time);
}

void enter(std::size_t cell, const std::vector<std::size_t>& neighbours, std::vector<Sweep>& sweeps) {
  Sweep& entered = sweeps[cell];
  entered.end = std::numeric_limits<double>::infinity();
  entered.residence = 0;
  for (const std::size_t neighbour : neighbours) {
    Sweep& before = sweeps[neighbour];
    if (!std::isinf(before.end) || before.begin >= entered.begin) continue;
    entered.residence = std::max(entered.residence, entered.begin - before.begin);
    before.end = entered.begin;
  }
}

}  // namespace fissura::cells
