// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/laws/carter_leak_off.hpp"

#include <cmath>

namespace fissura::network {

double face_leak_off(const CarterLaw& law, double exposure_time, double time) {
  if (time <= exposure_time) return 0;
  return law.spurt_volume + 2 * law.coefficient * std::sqrt(time - exposure_time);
}

double cell_leak_off(const CarterLaw& law, double exposure_begin, double exposure_end, double time) {
  if (time <= exposure_begin) return 0;
  const double oldest = time - exposure_begin;
  if (time < exposure_end) {
    const double swept = oldest / (exposure_end - exposure_begin);
    return swept * (2 * law.spurt_volume + 4 * law.coefficient * (2.0 / 3.0) * std::sqrt(oldest));
  }
  // (a^3/2 - b^3/2) / (a - b) without the difference, so that t_b = t_a needs no case of its own.
  const double youngest = time - exposure_end;
  const double mean_root =
      (oldest + std::sqrt(oldest * youngest) + youngest) / (std::sqrt(oldest) + std::sqrt(youngest));
  return 2 * law.spurt_volume + 4 * law.coefficient * (2.0 / 3.0) * mean_root;
}

}  // namespace fissura::network
