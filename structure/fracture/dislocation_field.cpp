// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/dislocation_field.hpp"

#include <complex>
#include <numbers>

namespace fissura::structure {

namespace {

using Complex = std::complex<double>;

Complex complex(const std::array<double, 2>& vector) {
  return {vector[0], vector[1]};
}

/// sigma_xx + sigma_yy, and sigma_yy - sigma_xx + 2 i sigma_xy.
struct Stress {
  double sum = 0;
  Complex difference;
};

/// Of a dislocation at a distance (place less its own).
Stress dislocation(Complex strength, Complex distance) {
  const Complex field = strength / distance;
  return {4 * field.real(), 2.0 * (std::conj(strength) - field * std::conj(distance)) / distance};
}

}  // namespace

InPlane<double> stress_of_jump(const DisplacementJump& jump, int parts, double plane_strain_modulus,
                               const Point& place) {
  const Complex begin = complex(jump.begin), step = (complex(jump.end) - begin) / static_cast<double>(parts);
  const Complex first = complex(jump.at_begin), change = complex(jump.at_end) - first, z = complex(place);
  const Complex factor(0, plane_strain_modulus / (8 * std::numbers::pi));
  Stress total;
  for (int part = 0; part < parts; ++part) {
    const Complex strength = factor * (first + change * ((part + 0.5) / parts));
    const Complex start = begin + static_cast<double>(part) * step;
    const Stress from = dislocation(strength, z - start), to = dislocation(strength, z - start - step);
    total.sum += from.sum - to.sum;
    total.difference += from.difference - to.difference;
  }
  return {(total.sum - total.difference.real()) / 2, (total.sum + total.difference.real()) / 2,
          total.difference.imag() / 2};
}

}  // namespace fissura::structure
