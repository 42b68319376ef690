// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

/// The only door to UDUNITS-2: text with a unit becomes a number in SI, whatever the locale of the process.
namespace fissura::input {

/// What a quantity measures: its SI unit is `unit` times s^`second_exponent`. The exponent is apart because
/// UDUNITS knows whole powers only.
struct Dimension {
  std::string_view name;     ///< for sentences, with its article: "a stress"
  std::string_view unit;     ///< SI, as UDUNITS reads it
  std::string_view example;  ///< for sentences: "32 GPa"
  double second_exponent = 0;
};

namespace dimension {
inline constexpr Dimension length{"a length", "m", "0.25 m"};
inline constexpr Dimension time{"a time", "s", "10 s"};
inline constexpr Dimension density{"a density", "kg/m^3", "2500 kg/m^3"};
inline constexpr Dimension stress{"a stress or pressure", "Pa", "10 MPa"};
inline constexpr Dimension gradient{"a stress per length", "Pa/m", "10 kPa/m"};
inline constexpr Dimension joint_compliance{"a length per stress", "m/Pa", "1e-11 m/Pa"};
inline constexpr Dimension energy_per_area{"an energy per area", "J/m^2", "50 N/m"};
inline constexpr Dimension velocity{"a velocity", "m/s", "2 m/s"};
inline constexpr Dimension acceleration{"an acceleration", "m/s^2", "-9.81 m/s^2"};
inline constexpr Dimension angle{"an angle", "radian", "40 degree"};
inline constexpr Dimension arc{"an angle", "degree", "56.7 degree"};  ///< kept in degrees
inline constexpr Dimension viscosity{"a viscosity", "Pa s", "1.67e-3 Pa s"};
inline constexpr Dimension rate{"a volume rate", "m^3/s", "1e-3 m^3/s"};
inline constexpr Dimension well_index{"a well index", "m^2/s/Pa", "1e-5 m^2/s/Pa"};
inline constexpr Dimension volume_per_area{"a volume per area", "m", "0.1 mm"};
inline constexpr Dimension carter_coefficient{"a Carter coefficient", "m", "5e-5 m/s^0.5", -0.5};

/// K of tau = K gamma^n, in Pa s^n; n is written as the letter or as its value.
constexpr Dimension consistency_index(double power_index) {
  return {"a consistency index", "Pa", "0.5 Pa s^n", power_index};
}
}  // namespace dimension

/// Value in SI of text such as "32 GPa", "5e-5 m/s^0.5", "5e-5 m/sqrt(s)" or "0.5 Pa s^n". The number may
/// have an exponent and uses a decimal point. Throws InputError if the text is not one finite number and one
/// unit of that dimension; what() tells what was expected, to stand behind "expected".
double in_si(std::string_view text, const Dimension& dimension);

/// The size of one `unit` in SI, e.g. 1e6 for "MPa". Throws InputError as above.
double unit_in_si(std::string_view unit, const Dimension& dimension);

}  // namespace fissura::input
