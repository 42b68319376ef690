// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "tests/reference/fixed_crack.hpp"

using namespace fissura::reference;

namespace {

void print(int cells, double step, const std::vector<fixed_crack::Inlet>& rows) {
  for (const auto& row : rows)
    std::printf("%d,%g,%g,%.5g,%.5g\n", cells, step, row.time, row.aperture, row.pressure);
}

}  // namespace

/// Prints how the monolithic fixed crack converges with its cells; cells = 0 is the extrapolated limit.
int main() {
  const auto parameters = fixed_crack::case_parameters();
  const auto times = fixed_crack::case_times();
  std::puts("cells,step,time,inlet_aperture,inlet_pressure");
  print(41, 0.005, fixed_crack::solve(parameters, 41, 0.005, times));
  for (const int cells : {81, 161, 321})
    print(cells, 0.05, fixed_crack::solve(parameters, cells, 0.05, times));
  print(0, 0, fixed_crack::extrapolate(parameters, 121, 0.1, times));
  return 0;
}
