// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/geographic_place.hpp"

#include <cmath>
#include <numbers>

namespace fissura::coupler {

namespace {

constexpr double equatorial_radius = 6378137.0, flattening = 1 / 298.257223563;
constexpr double degree = std::numbers::pi / 180;

double along(const std::array<double, 3>& axis, const std::array<double, 2>& position) {
  return axis[0] * position[0] + axis[1] * position[1];
}

}  // namespace

GeographicPlace geographic_place(const std::array<double, 2>& position, const Georeference& georeference,
                                 const Geography& geography) {
  const double east = along(geography.east, position), north = along(geography.north, position);
  const double depth = georeference.depth - along(geography.up, position);
  const double latitude = georeference.latitude * degree;
  const double eccentricity = flattening * (2 - flattening);
  const double root = std::sqrt(1 - eccentricity * std::sin(latitude) * std::sin(latitude));
  const double across = equatorial_radius / root - depth;
  const double meridian = equatorial_radius * (1 - eccentricity) / (root * root * root) - depth;
  const double slope = std::tan(latitude);

  GeographicPlace place;
  place.depth = depth;
  place.latitude = georeference.latitude + (north - slope * east * east / (2 * across)) / meridian / degree;
  const double longitude =
      georeference.longitude + east / (std::cos(latitude) * across) * (1 + slope * north / across) / degree;
  place.longitude = longitude > 180 ? longitude - 360 : longitude <= -180 ? longitude + 360 : longitude;
  return place;
}

}  // namespace fissura::coupler
