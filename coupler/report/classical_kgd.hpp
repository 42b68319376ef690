// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace fissura::coupler {

/// The classical plane-strain fracture without toughness, leak-off and fluid lag (Geertsma and de Klerk
/// 1969), q the rate of one wing per unit thickness:
///   L   = 0.48 (8 G q^3 / ((1-nu) mu))^(1/6) t^(2/3)
///   w_0 = 1.32 (8 (1-nu) mu q^3 / G)^(1/6) t^(1/3)
///   p_0 = w_0 E' / (4 L),  E' = 2 G / (1-nu)    (line crack under uniform pressure, Sneddon 1946)
struct ClassicalKgd {
  double shear_modulus = 0;   ///< G [Pa]
  double poissons_ratio = 0;  ///< nu [-]
  double viscosity = 0;       ///< mu [Pa s]
  double wing_rate = 0;       ///< q [m2/s], half of the injected one

  /// The rate is constant from `begin` to `end`; the volume injected by the time t is that of the constant
  /// rate over t - `advance`. [s]
  double begin = 0, end = 0, advance = 0;

  [[nodiscard]] double half_length(double time) const;         ///< [m], `time` [s] > 0 at the full rate
  [[nodiscard]] double inlet_aperture(double time) const;      ///< [m]
  [[nodiscard]] double inlet_net_pressure(double time) const;  ///< [Pa]
};

/// The classical solution of a case as it stands in effective_case.json; nothing if its first stage is not
/// the injection of a Newtonian fluid at a constant rate through one perforation. A ramp of the rate is taken
/// into account by its volume.
std::optional<ClassicalKgd> classical_kgd(const nlohmann::json& effective_case);

}  // namespace fissura::coupler
