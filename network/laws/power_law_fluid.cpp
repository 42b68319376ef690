// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/power_law_fluid.hpp"

#include <cmath>

namespace fissura::network {

namespace {

/// True wall shear rate over that of a Newtonian fluid at the same velocity (Rabinowitsch).
double wall_rate_factor(double n) {
  return (2 * n + 1) / (3 * n);
}

}  // namespace

double viscosity_from_velocity(const PowerLaw& fluid, double aperture, double velocity) {
  const double n = fluid.power_index;
  if (fluid.newtonian()) return fluid.consistency_index;
  return fluid.consistency_index * std::pow(wall_rate_factor(n), n) *
         std::pow(6 * velocity / aperture, n - 1);
}

double viscosity_from_gradient(const PowerLaw& fluid, double aperture, double gradient) {
  const double n = fluid.power_index;
  if (fluid.newtonian()) return fluid.consistency_index;
  return wall_rate_factor(n) * std::pow(fluid.consistency_index, 1 / n) *
         std::pow(0.5 * aperture * gradient, (n - 1) / n);
}

double gradient_from_velocity(const PowerLaw& fluid, double aperture, double velocity) {
  const double n = fluid.power_index;
  const double wall_rate = wall_rate_factor(n) * 6 * velocity / aperture;
  return 2 * fluid.consistency_index / aperture * std::pow(wall_rate, n);
}

double secant_viscosity(const PowerLaw& fluid, double aperture, double gradient, double velocity) {
  if (fluid.newtonian()) return fluid.consistency_index;
  const double weight = fluid.power_index / (1 + fluid.power_index);
  const double driving =
      std::pow(gradient, weight) * std::pow(gradient_from_velocity(fluid, aperture, velocity), 1 - weight);
  return viscosity_from_gradient(fluid, aperture, std::hypot(driving, gradient_floor));
}

}  // namespace fissura::network
