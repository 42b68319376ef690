// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/cells/cell_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fissura::cells {

namespace {

/// Aperture at p = 0 of the branch on which the compliance counts [m]; negative if it opens later.
double branch_begin(const CellLaw& law) {
  return law.aperture - law.compliance * law.reference_pressure;
}

/// The greater root p of  length ((b + C p) (1 + p / K) - content) = supply - conductance p.
double on_branch(const CellLaw& law, double length, double content, double conductance, double supply) {
  const double begin = branch_begin(law);
  const double square = length * law.compliance / law.bulk_modulus;
  const double linear = length * (law.compliance + begin / law.bulk_modulus) + conductance;
  const double constant = length * (begin - content) - supply;
  const double root = std::sqrt(std::max(0.0, linear * linear - 4 * square * constant));
  return linear + root > 0 ? -2 * constant / (linear + root) : 0;
}

}  // namespace

double cell_aperture(const CellLaw& law, double pressure) {
  const double increment = pressure - law.reference_pressure;
  if (law.closed && increment < 0) return law.aperture;
  return std::max(0.0, law.aperture + law.compliance * increment);
}

double cell_content(const CellLaw& law, double pressure) {
  return cell_aperture(law, pressure) * (1 + pressure / law.bulk_modulus);
}

double opening_pressure(const CellLaw& law) {
  if (law.compliance == 0) return law.aperture > 0 ? 0 : std::numeric_limits<double>::infinity();
  if (law.closed) return std::max(0.0, law.reference_pressure);
  return std::max(0.0, law.reference_pressure - law.aperture / law.compliance);
}

double cell_pressure(const CellLaw& law, double content) {
  const double opening = opening_pressure(law);
  if (content <= 0 || std::isinf(opening)) return 0;
  if (law.closed && content <= cell_content(law, opening)) {
    if (law.aperture <= 0) return opening;
    return std::clamp(law.bulk_modulus * (content / law.aperture - 1), 0.0, opening);
  }
  return std::max(0.0, on_branch(law, 1, content, 0, 0));
}

double cell_filled(const CellLaw& law, double pressure, double content) {
  if (pressure > 0) return 1;
  const double room = cell_aperture(law, 0);
  if (room <= 0 || content <= 0) return 0;
  return std::min(content / room, std::nextafter(1.0, 0.0));
}

double balanced_pressure(const CellLaw& law, double length, double content, double conductance,
                         double supply) {
  const double room = cell_content(law, 0);
  if (length * (room - content) >= supply) return 0;
  const double opening = opening_pressure(law);
  const double slope = law.closed ? length * law.aperture / law.bulk_modulus : 0;
  const double below = (supply + length * (content - room)) / (slope + conductance);
  return below <= opening ? below : on_branch(law, length, content, conductance, supply);
}

}  // namespace fissura::cells
