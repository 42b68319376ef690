// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "common/case/case.hpp"
#include "coupler/seismicity/moment_tensor.hpp"

namespace fissura::coupler {

struct GeographicPlace {
  double latitude = 0, longitude = 0;  ///< geodetic, WGS 84; -180 < longitude <= 180 [degree]
  double depth = 0;                    ///< below the level that the depth of the origin is counted from [m]
};

/// Where a point of the model (x, y) [m] lies, for models that are small against the Earth. East, north and
/// up are axes of a plane that touches the ellipsoid beneath the origin; with its radii of curvature there,
/// M along the meridian and N across it, second order in the distance:
///   depth     = depth_0 - up
///   latitude  = latitude_0  + (north - tan(latitude_0) east^2 / (2 (N - depth))) / (M - depth)
///   longitude = longitude_0 + east / (cos(latitude_0) (N - depth)) (1 + tan(latitude_0) north / (N - depth))
/// Depth follows the model's own vertical, not the curvature of the Earth. @pre not at a pole
GeographicPlace geographic_place(const std::array<double, 2>& position, const Georeference& georeference,
                                 const Geography& geography);

}  // namespace fissura::coupler
