// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/fluid_content.hpp"

#include <algorithm>

namespace fissura::network {

namespace {

struct Opening {
  double aperture, slope;
};

Opening predicted_opening(const ContentLaw& law, double pressure) {
  const double increment = pressure - law.reference_pressure;
  if (law.faces == Faces::in_contact && increment < 0) return {law.aperture, 0};
  const double aperture = law.aperture + law.compliance * increment;
  if (aperture < 0) return {0, 0};
  return {aperture, law.compliance};
}

Opening opening(const ContentLaw& law, double pressure) {
  const auto [predicted, slope] = predicted_opening(law, pressure);
  const double aperture = predicted + joint_opening(law.joint, pressure);
  if (aperture < 0) return {0, 0};
  return {aperture, pressure < law.joint.contact_pressure ? slope + law.joint.compliance : slope};
}

}  // namespace

double joint_opening(const JointLaw& law, double pressure) {
  return law.compliance * (std::min(pressure, law.contact_pressure) - law.formation_pressure);
}

double predicted_aperture(const ContentLaw& law, double pressure) {
  return predicted_opening(law, pressure).aperture;
}

double hydraulic_aperture(const ContentLaw& law, double pressure) {
  return opening(law, pressure).aperture;
}

NodeContent fluid_content(const ContentLaw& law, double u) {
  const double pressure = u > 0 ? u * pressure_scale : 0;
  const auto [aperture, slope] = opening(law, pressure);
  if (u < 0) {
    const double unfilled_slope = std::max(aperture, law.film);
    return {0, 0, aperture, aperture + u * unfilled_slope, unfilled_slope};
  }
  const double density = 1 + pressure / law.bulk_modulus;
  return {pressure, pressure_scale, aperture, aperture * density,
          pressure_scale * (slope * density + aperture / law.bulk_modulus)};
}

double unfilled_unknown(const ContentLaw& law, double content) {
  const double aperture = hydraulic_aperture(law, 0);
  return (content - aperture) / std::max(aperture, law.film);
}

}  // namespace fissura::network
