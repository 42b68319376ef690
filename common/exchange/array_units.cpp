// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/exchange/array_units.hpp"

#include <fmt/format.h>

#include <array>

namespace fissura {

namespace {

struct KnownArray {
  std::string_view name, unit;
};

constexpr std::array known_arrays{
    // fracture network
    KnownArray{"aperture", "m"}, KnownArray{"aperture_rate", "m/s"}, KnownArray{"aperture_begin", "m"},
    KnownArray{"aperture_end", "m"}, KnownArray{"aperture_predicted", "m"}, KnownArray{"arm_aperture_a", "m"},
    KnownArray{"arm_aperture_b", "m"}, KnownArray{"pressure", "Pa"}, KnownArray{"pressure_begin", "Pa"},
    KnownArray{"pressure_end", "Pa"}, KnownArray{"pressure_applied", "Pa"},
    KnownArray{"pressure_opening", "Pa"}, KnownArray{"reference_pressure", "Pa"},
    KnownArray{"compliance", "m/Pa"}, KnownArray{"stiffness", "Pa/m"}, KnownArray{"closed", "1"},
    KnownArray{"broken", "1"}, KnownArray{"filled", "1"}, KnownArray{"content", "m"},
    KnownArray{"leaked", "m"}, KnownArray{"flux", "m2/s"}, KnownArray{"fluid_fraction", "1"},
    KnownArray{"neutral_content", "m"}, KnownArray{"neutral_pressure", "Pa"},
    KnownArray{"neutral_leaked", "m"}, KnownArray{"neutral_exposure_time", "s"},
    KnownArray{"neutral_contact_pressure", "Pa"}, KnownArray{"neutral_joining", "1"},
    KnownArray{"neutral_fluid_fraction", "1"},
    // rock
    KnownArray{"position", "m"}, KnownArray{"elements", "1"}, KnownArray{"displacement", "m"},
    KnownArray{"velocity", "m/s"}, KnownArray{"effective_stress_xx", "Pa"},
    KnownArray{"effective_stress_yy", "Pa"}, KnownArray{"effective_stress_xy", "Pa"},
    KnownArray{"effective_stress_zz", "Pa"}, KnownArray{"damage", "1"}, KnownArray{"plastic_strain", "1"},
    // contact units
    KnownArray{"joint_position", "m"}, KnownArray{"joint_normal", "1"}, KnownArray{"joint_kind", "1"},
    KnownArray{"joint_line", "1"}, KnownArray{"joint_slip", "m"}, KnownArray{"joint_opening", "m"},
    KnownArray{"joint_normal_traction", "Pa"}, KnownArray{"joint_shear_traction", "Pa"},
    KnownArray{"joint_pressure", "Pa"}, KnownArray{"joint_wetted", "1"},
    // seismic sources
    KnownArray{"source_kind", "1"}, KnownArray{"source_number", "1"}, KnownArray{"source_time", "s"},
    KnownArray{"source_position", "m"}, KnownArray{"source_normal", "1"}, KnownArray{"source_jump", "m"},
    KnownArray{"source_extent", "m2 or m3"}, KnownArray{"source_element_size", "m"},
    KnownArray{"source_moment", "N m"}, KnownArray{"source_pseudo_moment", "N m"},
    KnownArray{"source_measure", "1 or m"}, KnownArray{"source_peak_rate", "m/s"},
    KnownArray{"source_traction", "Pa"}, KnownArray{"source_fluid_pressure", "Pa"},
    KnownArray{"source_mass_scale", "1"}};

}  // namespace

std::optional<std::string_view> unit_of_array(std::string_view array_name) {
  for (const KnownArray& known : known_arrays)
    if (known.name == array_name) return known.unit;
  return std::nullopt;
}

std::optional<std::string> wrong_unit(const Message& message) {
  for (const Array& array : message.arrays) {
    const std::optional<std::string_view> expected = unit_of_array(array.name);
    if (expected && array.unit != *expected)
      return fmt::format("{} interval {}: {} must be in \"{}\", found \"{}\"", name(message.type),
                         message.interval, array.name, *expected, array.unit);
  }
  return std::nullopt;
}

}  // namespace fissura
