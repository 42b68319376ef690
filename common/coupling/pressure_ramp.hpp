// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fissura {

/// Fluid pressure on the faces of one network node between two coupling times, as the coupler hands it to the structure.
///   p_int(tau) = (1 - tau) pressure_begin + tau pressure_end            (Profit et al. 2016, Eqs. 19 and 22; in Eq. 22
///   e_ref(tau) = (1 - tau) aperture_begin + tau aperture_end             the difference is p_e - p_i, not p_i - p_e as printed)
///   p_e(tau)   = max(0, p_int - stiffness (e - e_ref))                  (Eq. 20, accumulated over the interval)
struct PressureRamp {
  double pressure_begin = 0;  ///< applied at the begin [Pa]
  double pressure_end = 0;    ///< of the network at the end [Pa]
  double aperture_begin = 0;  ///< of the structure at the begin [m]
  double aperture_end = 0;    ///< the network's prediction for the end [m]
  double stiffness = 0;       ///< k_s of the enclosed fluid, 0 where the node is not filled [Pa/m]

  /// Pressure for the aperture of the reference, before the stiffness acts [Pa]. @param tau  (t - t_c1) / dt_c in [0, 1]
  [[nodiscard]] double interpolated(double tau) const;

  /// e_ref [m]
  [[nodiscard]] double reference_aperture(double tau) const;

  /// p_e [Pa] for the structure's `aperture` [m]; never below zero.
  [[nodiscard]] double applied(double tau, double aperture) const;
};

}  // namespace fissura
