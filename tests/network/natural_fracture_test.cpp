// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/network/natural_setup.hpp"

using namespace fissura;
using namespace fissura::network;
using namespace fissura::network::test;

TEST_CASE("explore", "[.explore]") {
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (double cs : {0.0, 1e-12, 1e-11, 1e-10}) {
      Model model = water_model();
      model.schedule = constant_rate(1e-3);
      model.leak_off = {1e-5, 0};
      NaturalSetup setup = pumped_fracture(model, 1e-4);
      std::mt19937 random(seed);
      long it = 0, halv = 0, steps = 0;
      int worst = 0;
      double residual = 0;
      for (int k = 0; k < 400; ++k) {
        if (k % 8 == 4) {
          std::vector<std::size_t> from;
          for (unsigned j = 0; j <= random() % 3; ++j) from.push_back(random() % setup.count());
          NaturalFracture n;
          n.joint_compliance = cs;
          n.residual_aperture = random() % 4 == 0 ? 0 : 5e-5;
          n.formation_pressure = 1e6 * (random() % 10);
          n.opening_pressure = n.formation_pressure + 1e6 * (1 + random() % 6);
          setup.join(from, 1 + random() % 8, n);
        }
        if (k % 8 == 6) setup.grow(random() % setup.count());
        const AdvanceReport r = setup.advance(0.01 * (1 + random() % 10));
        it += r.newton.iterations;
        worst = std::max(worst, r.newton.iterations);
        halv += r.halvings;
        steps += r.steps;
        residual = std::max(residual, setup.relative_residual());
      }
      double top = *std::max_element(setup.flow.state.pressure.begin(), setup.flow.state.pressure.end());
      printf(
          "seed %u cs %g nodes %zu: iterations %.2f worst %d halvings %ld residual %.1e found %g inlet %g "
          "top %g\n",
          seed, cs, setup.count(), double(it) / steps, worst, halv, residual,
          setup.flow.state.ledger.found.value(), setup.flow.state.pressure[0], top);
    }
}
