// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Carter leak-off with spurt (Carter 1957; Howard and Fast 1957; Profit et al. 2016, Eq. 6), as cumulative
/// volumes: the rate C_l / sqrt(t - t_exp) is singular at exposure and is never evaluated.
namespace fissura::network {

struct CarterLaw {
  double coefficient = 0;   ///< C_l of ONE face [m/s^0.5]
  double spurt_volume = 0;  ///< S_p of one face [m3/m2]

  [[nodiscard]] bool active() const { return coefficient > 0 || spurt_volume > 0; }
};

/// Volume lost through one face, per area [m]:  S_p + 2 C_l sqrt(t - t_exp), and 0 up to t = t_exp.
double face_leak_off(const CarterLaw& law, double exposure_time, double time);

/// Volume lost through both faces of a cell that the front sweeps evenly from t_a to t_b, per trace length
/// and thickness [m]:
///   2 S_p f + 4 C_l (2/3) ((t - t_a)^(3/2) - <t - t_b>^(3/2)) / (t_b - t_a),     f = min(1, (t - t_a) / (t_b
///   - t_a))
/// the mean of face_leak_off over the part exposed at time t; for t_b = t_a twice face_leak_off.
/// @param exposure_begin  t_a [s]
/// @param exposure_end    t_b [s], >= t_a
double cell_leak_off(const CarterLaw& law, double exposure_begin, double exposure_end, double time);

}  // namespace fissura::network
