// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A fracture of constant width that loses fluid by Carter's law: G. C. Howard and C. R. Fast, Drilling and
/// Production Practice, API (1957) 261, with R. D. Carter's appendix.
namespace fissura::reference::carter {

/// Area of one face [m2 per unit thickness] at `time` [s] of a fracture of constant `width` w [m] fed with
/// `rate` Q [m2/s] and losing C_l / sqrt(t - t_exposed) [m/s] plus the spurt S_p [m] through each of its two
/// faces:
///   A = Q (w + 2 S_p) / (4 pi C_l^2) (exp(b^2) erfc(b) + 2 b / sqrt(pi) - 1),  b = 2 C_l sqrt(pi t) / (w + 2
///   S_p)
/// `leak_off_coefficient` C_l > 0 [m/s^0.5].
double face_area(double rate, double width, double leak_off_coefficient, double spurt_volume, double time);

/// Volume lost through one face since its exposure: S_p + 2 C_l sqrt(age) [m3/m2]; `age` >= 0 [s].
double lost_through_face(double leak_off_coefficient, double spurt_volume, double age);

}  // namespace fissura::reference::carter
