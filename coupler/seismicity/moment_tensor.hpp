// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "common/seismicity/source_record.hpp"

/// Source mechanics of one moment tensor. Laws: no file, no socket. Tensors in the axes of the case with
/// M_zz, as plane strain has it; x y z is a right-handed system [N m].
namespace fissura::coupler {

/// Eigenvalues in descending order with their unit eigenvectors (x, y, z), right-handed [N m]. Where the one
/// across the plane equals another, z is the middle axis.
struct PrincipalMoments {
  std::array<double, 3> value{};
  std::array<std::array<double, 3>, 3> axis{};
};

PrincipalMoments principal_moments(const PlaneTensor& moment);

/// M0 = sqrt(sum M_ij^2 / 2)  (Silver & Jordan 1982)  [N m]; the one that is reported.
double scalar_moment(const PlaneTensor& moment);

/// |tr M / 3| + greatest absolute deviatoric eigenvalue (Bowers & Hudson 1999)  [N m].
double scalar_moment_bowers_hudson(const PlaneTensor& moment);

/// Mw = 2/3 (log10 M0 - 9.1)  (IASPEI)  [-]. @pre scalar_moment > 0
double moment_magnitude(double scalar_moment);

/// The moment of a magnitude [N m].
double moment_of_magnitude(double magnitude);

/// Shares of the moment (Vavrycuk 2015), |iso| + |clvd| + dc = 1; all 0 of a tensor that is 0 [-].
struct Decomposition {
  double iso = 0;   ///< positive: explosion
  double clvd = 0;  ///< positive: tension along the major axis
  double dc = 0;    ///< >= 0
};

Decomposition decomposition(const PrincipalMoments& moments);

/// Place in Hudson's skewed diamond,  m = M / max|M|:  u = -2/3 (m1 + m3 - 2 m2), v = (m1 + m2 + m3) / 3.
struct HudsonPoint {
  double u = 0, v = 0;
};

HudsonPoint hudson_point(const PrincipalMoments& moments);

/// Hudson's T and k of the same tensor (Hudson, Pearce & Rogers 1989).
struct HudsonTypes {
  double T = 0, k = 0;
};

HudsonTypes hudson_types(const PrincipalMoments& moments);

/// Angle between slip vector and plane of a shear-tensile source in isotropic rock,
///   sin(alpha) = (M1 + M3 - 2 M2) / (M1 - M3)  (Vavrycuk 2011), in -pi/2 .. pi/2 [rad]; 0 if M1 = M3.
double slope_angle(const PrincipalMoments& moments);

/// lambda / mu of the rock around it, 4/3 (C_ISO / C_CLVD + 1) - 2. @pre clvd != 0
double lame_ratio(const Decomposition& shares);

/// East, north, up in the axes of the case, for tensors and directions in geographic terms.
struct Geography {
  std::array<double, 3> east{1, 0, 0}, north{0, 1, 0}, up{0, 0, 1};
};

/// Strike clockwise from north with the dip to the right, dip from horizontal, rake of the hanging wall's
/// slip, counter-clockwise from strike (Aki & Richards 2002): 0 left-lateral, +90 thrust [rad].
/// 0 <= strike < 2 pi, 0 <= dip <= pi/2, -pi < rake <= pi. Of the two strikes of a vertical plane it is the
/// one from 315 over 0 to 135 degrees, so that rounding turns no plane along an axis; a horizontal plane
/// strikes north.
struct NodalPlane {
  double strike = 0, dip = 0, rake = 0;
};

/// Of the fault with this unit normal (x, y, z, either sign) whose side at +normal moved by `slip` against
/// the other one; only the part of the slip in the plane counts, and without any the rake is 0.
NodalPlane nodal_plane(const std::array<double, 3>& normal, const std::array<double, 3>& slip,
                       const Geography& geography);

/// Both planes of the double couple of a tensor; the first one is the one whose normal is nearest to
/// `true_normal` (x, y, z; either sign).
std::array<NodalPlane, 2> nodal_planes(const PrincipalMoments& moments,
                                       const std::array<double, 3>& true_normal, const Geography& geography);

/// Components r (up), t (south), p (east) in the order Mrr, Mtt, Mpp, Mrt, Mrp, Mtp  [N m].
std::array<double, 6> up_south_east(const PlaneTensor& moment, const Geography& geography);

/// Azimuth from north, clockwise, 0 .. 2 pi, and plunge below the horizontal, 0 .. pi/2 [rad].
struct AxisDirection {
  double azimuth = 0, plunge = 0;
};

AxisDirection axis_direction(const std::array<double, 3>& axis, const Geography& geography);

}  // namespace fissura::coupler
