// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/material.hpp"

#include <cmath>
#include <numbers>

namespace fissura::reference {

ScaledParameters scaled(const Rock& rock, const Treatment& treatment) {
  ScaledParameters p;
  p.viscosity = 12 * treatment.viscosity;
  p.modulus = rock.plane_strain_modulus;
  p.toughness = std::sqrt(32 / std::numbers::pi) * rock.toughness;
  p.leak_off = 2 * treatment.leak_off_coefficient;
  p.rate = treatment.rate;
  return p;
}

double dimensionless_toughness(const ScaledParameters& p) {
  return p.toughness / std::pow(p.viscosity * p.rate * std::pow(p.modulus, 3), 0.25);
}

}  // namespace fissura::reference
