// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/sneddon.hpp"

#include <cmath>
#include <numbers>

namespace fissura::reference::sneddon {

using std::numbers::pi;

double aperture(double net_pressure, double half_length, double plane_strain_modulus, double x) {
  return 4 * net_pressure / plane_strain_modulus * std::sqrt(half_length * half_length - x * x);
}

double volume(double net_pressure, double half_length, double plane_strain_modulus) {
  return 2 * pi * net_pressure * half_length * half_length / plane_strain_modulus;
}

double stress_intensity(double net_pressure, double half_length) {
  return net_pressure * std::sqrt(pi * half_length);
}

Arrest arrest(double volume, double toughness, double plane_strain_modulus) {
  Arrest result;
  result.half_length = std::pow(plane_strain_modulus * volume / (2 * std::sqrt(pi) * toughness), 2.0 / 3);
  result.net_pressure = toughness / std::sqrt(pi * result.half_length);
  result.aperture = aperture(result.net_pressure, result.half_length, plane_strain_modulus, 0);
  return result;
}

}  // namespace fissura::reference::sneddon
