// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

/// Fluid content of a node as a function of one unknown u that covers wet, partly filled and dry: the
/// complementarity p (1 - filled) = 0 of Elrod and Adams (1974).
namespace fissura::network {

enum class Faces : std::uint8_t { separated = 0, in_contact = 1 };

/// Pressure of u = 1 [Pa].
inline constexpr double pressure_scale = 1e6;

/// Hydraulic opening of the rough faces of a joint under the fluid, which the rock around does not feel
/// (Bandis et al. 1983, linear):
///   j(p) = c_s (min(p, p_c) - p_0)                     [m]
/// It ends where the contact carries nothing any more, p = p_c, and stays when the faces part.
struct JointLaw {
  double compliance = 0;          ///< c_s [m/Pa], >= 0
  double formation_pressure = 0;  ///< p_0, at which the structure's aperture is the whole one [Pa]
  double contact_pressure = 0;    ///< p_c, at which the contact opens [Pa]
};

/// j(p) [m]; negative below p_0.
double joint_opening(const JointLaw& law, double pressure);

/// What is known of a node before the solution.
///   e^(p) = max(0, aperture + compliance (p - reference_pressure))    in contact only the part p >
///   reference_pressure counts
///   e(p)  = max(0, e^(p) + j(p))
/// The compliance estimates what the structure will do with the pressure increment; it stores no fluid of its
/// own. j(p) does: the structure does not know of it.
struct ContentLaw {
  double aperture = 0;            ///< [m], >= 0; with carry = pressure extrapolated to the end of the step
  double compliance = 0;          ///< C_R [m/Pa], >= 0
  double reference_pressure = 0;  ///< carried by the structure when it measured `aperture` [Pa]
  double bulk_modulus = 0;        ///< K_f [Pa], > 0
  double film = 0;  ///< scale of u in a node without aperture [m], > 0; does not change the solution
  Faces faces = Faces::separated;
  JointLaw joint = {};
};

/// A node at one value of u; slopes are derivatives with respect to u.
struct NodeContent {
  double pressure = 0;        ///< p [Pa], >= 0
  double pressure_slope = 0;  ///< [Pa]
  double aperture = 0;        ///< e(p) [m], >= 0
  double content = 0;         ///< m [m]: volume at zero pressure per area of face
  double content_slope = 0;   ///< [m]
};

/// e^(p), what the structure will make of the pressure [m]. @param pressure  >= 0 [Pa]
double predicted_aperture(const ContentLaw& law, double pressure);

/// e(p), the room for fluid [m]. @param pressure  >= 0 [Pa]
double hydraulic_aperture(const ContentLaw& law, double pressure);

/// u >= 0: p = u pressure_scale,  m = e(p) (1 + p / K_f)         (filled)
/// u < 0:  p = 0,                 m = e(0) + u max(e(0), film)   (partly filled, dry at m = 0)
/// Continuous, never falling in u, and not bounded below: m < 0 is leak-off demand that the node could not
/// meet.
NodeContent fluid_content(const ContentLaw& law, double u);

/// The first u on the way from u_begin to u_end, both >= 0, at which the content begins to change more than
/// twice as fast: where an aperture leaves zero, where a contact opens, or where it closes; none if there is
/// no such place.
std::optional<double> first_steepening(const ContentLaw& law, double u_begin, double u_end);

/// The u < 0 whose content is `content` [m]. @pre content < e(0)
double unfilled_unknown(const ContentLaw& law, double content);

}  // namespace fissura::network
