// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/in_situ.hpp"

namespace fissura::structure {

InSituState in_situ_state(const Case& settings, const Point& position) {
  const InSitu& field = settings.in_situ;
  const auto linear = [&position](double origin, const std::array<double, 2>& gradient) {
    return origin + gradient[0] * position[0] + gradient[1] * position[1];
  };
  const auto stress = [&field, &linear](int component) {
    return linear(field.stress[component], field.stress_gradient[component]);
  };
  return {{stress(0), stress(1), stress(2)},
          stress(3),
          settings.rock.biot_coefficient * linear(field.pore_pressure, field.pore_pressure_gradient)};
}

}  // namespace fissura::structure
