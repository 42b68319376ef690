// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/carter.hpp"

#include <cmath>
#include <numbers>

namespace fissura::reference::carter {

using std::numbers::pi;

double face_area(double rate, double width, double leak_off_coefficient, double spurt_volume, double time) {
  const double c = leak_off_coefficient, store = width + 2 * spurt_volume;
  const double b = 2 * c * std::sqrt(pi * time) / store;
  return rate * store / (4 * pi * c * c) * (std::exp(b * b) * std::erfc(b) + 2 * b / std::sqrt(pi) - 1);
}

double lost_through_face(double leak_off_coefficient, double spurt_volume, double age) {
  return spurt_volume + 2 * leak_off_coefficient * std::sqrt(age);
}

}  // namespace fissura::reference::carter
