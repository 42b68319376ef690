// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

enum class StressSign { compression_positive, tension_positive };

constexpr std::array stress_signs{Named<StressSign>{"compression_positive", StressSign::compression_positive},
                                  Named<StressSign>{"tension_positive", StressSign::tension_positive}};

/// Without a sign no stress can be read.
double factor_of(std::optional<StressSign> sign) {
  if (!sign) return std::numeric_limits<double>::quiet_NaN();
  return *sign == StressSign::tension_positive ? 1 : -1;
}

std::array<double, 4> components(double maximum_horizontal, double minimum_horizontal, double vertical,
                                 double azimuth) {
  const double mean = (maximum_horizontal + minimum_horizontal) / 2;
  const double deviator = (maximum_horizontal - minimum_horizontal) / 2;
  return {mean - deviator * std::cos(2 * azimuth), mean + deviator * std::cos(2 * azimuth),
          deviator * std::sin(2 * azimuth), vertical};
}

void read_gradient(TableReader& table, double to_tension_positive, InSitu& in_situ) {
  constexpr std::array<std::string_view, 4> keys{"stress_xx", "stress_yy", "stress_xy", "stress_zz"};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (!table.has(keys[i])) continue;
    const std::array<double, 2> gradient = table.vector(keys[i], dimension::gradient);
    in_situ.stress_gradient[i] = {to_tension_positive * gradient[0], to_tension_positive * gradient[1]};
  }
  in_situ.pore_pressure_gradient =
      table.vector("pore_pressure", dimension::gradient, in_situ.pore_pressure_gradient);
  table.refuse_unknown_keys();
}

}  // namespace

InSitu read_in_situ(TableReader& document) {
  TableReader table = document.table("in_situ");
  const double to_tension_positive = factor_of(table.choice("sign", stress_signs));
  const double maximum = table.quantity("maximum_horizontal_stress", dimension::stress, any_value);
  const double minimum = table.quantity("minimum_horizontal_stress", dimension::stress, any_value);
  const double vertical = table.quantity("vertical_stress", dimension::stress, any_value);
  const double azimuth = table.quantity("maximum_horizontal_azimuth", dimension::angle, any_value);

  InSitu in_situ;
  in_situ.stress = components(to_tension_positive * maximum, to_tension_positive * minimum,
                              to_tension_positive * vertical, azimuth);
  in_situ.pore_pressure = table.quantity("pore_pressure", dimension::stress, not_negative);
  in_situ.body_acceleration =
      table.vector("body_acceleration", dimension::acceleration, in_situ.body_acceleration);
  TableReader gradient = table.optional_table("gradient");
  read_gradient(gradient, to_tension_positive, in_situ);

  if (to_tension_positive * maximum > to_tension_positive * minimum)
    table.refuse(
        "maximum_horizontal_stress",
        "at least as much compression as minimum_horizontal_stress; compression counts by in_situ.sign");
  table.refuse_unknown_keys();
  return in_situ;
}

}  // namespace fissura::input
