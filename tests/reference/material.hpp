// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the plane-strain solutions of this folder need to know. SI units; rates are of both wings, per unit
/// thickness.
namespace fissura::reference {

struct Rock {
  double plane_strain_modulus = 0;  ///< E' = E / (1 - nu^2) [Pa]
  double toughness = 0;             ///< K_Ic [Pa m^0.5]; sqrt(E' G_f) for a cohesive tip
};

struct Treatment {
  double viscosity = 0;             ///< mu of a Newtonian fluid [Pa s]
  double rate = 0;                  ///< Q_0 of both wings, constant from t = 0 [m2/s]
  double leak_off_coefficient = 0;  ///< C_l of ONE face [m/s^0.5]
};

/// State of a fracture of two equal wings at one time.
struct KgdState {
  double time = 0;                ///< [s]
  double half_length = 0;         ///< [m]
  double inlet_aperture = 0;      ///< [m]
  double inlet_net_pressure = 0;  ///< fluid pressure minus closure stress [Pa]
  double efficiency = 1;          ///< fluid in the fracture over fluid injected [-]
};

/// Scaled parameters of Detournay and Garagash:  mu' = 12 mu,  K' = sqrt(32/pi) K_Ic,  C' = 2 C_l.
struct ScaledParameters {
  double viscosity = 0;  ///< mu' [Pa s]
  double modulus = 0;    ///< E' [Pa]
  double toughness = 0;  ///< K' [Pa m^0.5]
  double leak_off = 0;   ///< C' [m/s^0.5]
  double rate = 0;       ///< Q_0 [m2/s]
};

ScaledParameters scaled(const Rock& rock, const Treatment& treatment);

/// Dimensionless toughness K_m = (K'^4 / (mu' Q_0 E'^3))^(1/4): viscosity rules below about 1, toughness
/// above 4.
double dimensionless_toughness(const ScaledParameters& p);

}  // namespace fissura::reference
