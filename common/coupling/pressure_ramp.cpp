// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/coupling/pressure_ramp.hpp"

#include <algorithm>

namespace fissura {

double PressureRamp::interpolated(double tau) const {
  return (1 - tau) * pressure_begin + tau * pressure_end;
}

double PressureRamp::reference_aperture(double tau) const {
  return (1 - tau) * aperture_begin + tau * aperture_end;
}

double PressureRamp::applied(double tau, double aperture) const {
  return std::max(0.0, interpolated(tau) - stiffness * (aperture - reference_aperture(tau)));
}

}  // namespace fissura
