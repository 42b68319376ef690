// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/cubic_law.hpp"

#include <algorithm>

namespace fissura::network {

double permeability(double aperture) {
  return aperture * aperture / 12;
}

double segment_aperture(double aperture_a, double aperture_b, double minimum_aperture) {
  return 0.5 * (std::max(aperture_a, minimum_aperture) + std::max(aperture_b, minimum_aperture));
}

double transmissibility(double aperture, double viscosity, double length) {
  return aperture * permeability(aperture) / (viscosity * length);
}

}  // namespace fissura::network
