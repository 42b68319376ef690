// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/material/elasticity.hpp"

#include <cmath>

namespace fissura::structure {

double compression_wave_speed(const Elasticity& moduli, double density) {
  return std::sqrt((moduli.lame + 2 * moduli.shear) / density);
}

double shear_wave_speed(const Elasticity& moduli, double density) {
  return std::sqrt(moduli.shear / density);
}

}  // namespace fissura::structure
