// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/kgd_vertices.hpp"

#include <cmath>
#include <numbers>

namespace fissura::reference::kgd_vertices {
namespace {

using std::numbers::pi;

double pressure_at_toughness(const ScaledParameters& p, double half_length) {
  return p.toughness / std::sqrt(32 * half_length);
}

}  // namespace

KgdState m(const ScaledParameters& p, double time) {
  KgdState state;
  state.time = time;
  state.half_length =
      0.6159 * std::pow(std::pow(p.rate, 3) * p.modulus * std::pow(time, 4) / p.viscosity, 1.0 / 6);
  state.inlet_aperture =
      1.1265 * std::pow(p.viscosity * std::pow(p.rate, 3) * time * time / p.modulus, 1.0 / 6);
  state.inlet_net_pressure = 0.5469 * p.modulus * std::cbrt(p.viscosity / (p.modulus * time));
  return state;
}

KgdState k(const ScaledParameters& p, double time) {
  KgdState state;
  state.time = time;
  state.half_length = 0.9324 * std::pow(p.modulus * p.rate * time / p.toughness, 2.0 / 3);
  state.inlet_aperture =
      0.6828 * std::cbrt(p.toughness * p.toughness * p.rate * time / (p.modulus * p.modulus));
  state.inlet_net_pressure = pressure_at_toughness(p, state.half_length);
  return state;
}

KgdState m_tilde(const ScaledParameters& p, double time) {
  KgdState state;
  state.time = time;
  state.half_length = p.rate * std::sqrt(time) / (pi * p.leak_off);
  state.inlet_aperture =
      0.8165 *
      std::pow(p.viscosity * std::pow(p.rate, 3) * time / (p.modulus * p.leak_off * p.leak_off), 0.25);
  state.efficiency = 0;
  return state;
}

KgdState k_tilde(const ScaledParameters& p, double time) {
  KgdState state;
  state.time = time;
  state.half_length = p.rate * std::sqrt(time) / (pi * p.leak_off);
  state.inlet_aperture = 0.3989 * std::pow(std::pow(p.toughness, 4) * p.rate * p.rate * time /
                                               (std::pow(p.modulus, 4) * p.leak_off * p.leak_off),
                                           0.25);
  state.inlet_net_pressure = pressure_at_toughness(p, state.half_length);
  state.efficiency = 0;
  return state;
}

}  // namespace fissura::reference::kgd_vertices
