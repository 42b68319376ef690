// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/fluid_content.hpp"

#include <algorithm>
#include <vector>

namespace fissura::network {

namespace {

/// Distance from a kink at which its two sides are looked at, in u.
constexpr double beside_kink = 1e-6;

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

/// Aperture without its bound at zero.
double unbounded_aperture(const ContentLaw& law, double pressure) {
  return predicted_opening(law, pressure).aperture + joint_opening(law.joint, pressure);
}

/// Pressures at which the slope of e(p) jumps, rising.
std::vector<double> kinks(const ContentLaw& law) {
  std::vector<double> places;
  if (law.faces == Faces::in_contact)
    places.push_back(law.reference_pressure);
  else if (law.compliance > 0)
    places.push_back(law.reference_pressure - law.aperture / law.compliance);
  if (law.joint.compliance > 0) places.push_back(law.joint.contact_pressure);
  std::sort(places.begin(), places.end());
  if (law.joint.compliance == 0 || unbounded_aperture(law, 0) >= 0) return places;

  double low = 0;
  for (const double place : places)
    if (place > low && unbounded_aperture(law, place) <= 0) low = place;
  const double slope =
      (unbounded_aperture(law, low + pressure_scale * beside_kink) - unbounded_aperture(law, low)) /
      (pressure_scale * beside_kink);
  if (slope <= 0) return places;
  places.push_back(low - unbounded_aperture(law, low) / slope);
  std::sort(places.begin(), places.end());
  return places;
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

std::optional<double> first_steepening(const ContentLaw& law, double u_begin, double u_end) {
  std::vector<double> places = kinks(law);
  if (u_end < u_begin) std::reverse(places.begin(), places.end());
  const double beyond = u_end < u_begin ? -beside_kink : beside_kink;
  for (const double pressure : places) {
    const double u = pressure / pressure_scale;
    if (u <= std::min(u_begin, u_end) || u >= std::max(u_begin, u_end)) continue;
    const double before = fluid_content(law, u - beyond).content_slope;
    if (fluid_content(law, u + beyond).content_slope > 2 * before) return u;
  }
  return std::nullopt;
}

double unfilled_unknown(const ContentLaw& law, double content) {
  const double aperture = hydraulic_aperture(law, 0);
  return (content - aperture) / std::max(aperture, law.film);
}

}  // namespace fissura::network
