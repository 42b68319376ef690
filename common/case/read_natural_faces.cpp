// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

constexpr double aperture_of_bare_faces = 5e-5;         // [m]
constexpr double compliance_of_touching_faces = 1e-11;  // [m/Pa]
constexpr Range below_right_angle{0, std::numbers::pi / 2, true, false};
constexpr std::array natural_keys{"dilation_angle", "dilation_slip", "residual_aperture", "joint_compliance"};

void read_dilation(TableReader& table, FractureLine& line) {
  line.dilation_angle =
      table.quantity("dilation_angle", dimension::angle, below_right_angle, line.dilation_angle);
  line.dilation_slip = table.quantity("dilation_slip", dimension::length, not_negative, line.dilation_slip);
  const std::array concerned{"dilation_angle", "dilation_slip", "friction_coefficient"};
  if (std::none_of(concerned.begin(), concerned.end(), [&](const char* key) { return table.has(key); }))
    return;
  if (line.dilation_angle > 0 && line.dilation_slip == 0)
    table.refuse(
        "dilation_slip",
        "greater than 0 m with a dilation_angle greater than 0: sliding faces cannot dilate for ever");
  if (line.dilation_angle > std::atan(line.friction_coefficient))
    table.refuse("dilation_angle", fmt::format("{:.4g} degree", line.dilation_angle * 180 / std::numbers::pi),
                 "at most the angle of friction: more would make energy out of sliding");
}

}  // namespace

void read_strength(TableReader& table, FractureLine& line) {
  line.tensile_strength =
      table.quantity("tensile_strength", dimension::stress, not_negative, line.tensile_strength);
  line.fracture_energy =
      table.quantity("fracture_energy", dimension::energy_per_area, not_negative, line.fracture_energy);
  if ((line.tensile_strength == 0) != (line.fracture_energy == 0))
    table.refuse(line.tensile_strength == 0 ? "tensile_strength" : "fracture_energy",
                 "tensile_strength and fracture_energy both greater than zero, or both zero");
}

NaturalFaces unspecified_natural_faces() {
  NaturalFaces faces;
  faces.line.joint_compliance = compliance_of_touching_faces;
  return faces;
}

NaturalFaces read_natural_faces(TableReader& table, const NaturalFaces& before, Friction friction) {
  NaturalFaces faces = before;
  FractureLine& line = faces.line;
  line.kind = FractureKind::natural;
  read_strength(table, line);
  if (table.has("friction_coefficient") || (friction == Friction::required && !before.friction_is_given)) {
    line.friction_coefficient = table.number("friction_coefficient", not_negative);
    faces.friction_is_given = true;
  } else if (!before.friction_is_given) {
    line.friction_coefficient = std::numeric_limits<double>::quiet_NaN();
  }
  line.cohesion = table.quantity("cohesion", dimension::stress, not_negative, line.cohesion);
  read_dilation(table, line);
  faces.residual_aperture_is_given = before.residual_aperture_is_given || table.has("residual_aperture");
  if (!faces.residual_aperture_is_given)
    line.residual_aperture = line.tensile_strength > 0 ? 0 : aperture_of_bare_faces;
  line.residual_aperture =
      table.quantity("residual_aperture", dimension::length, not_negative, line.residual_aperture);
  line.joint_compliance =
      table.quantity("joint_compliance", dimension::joint_compliance, not_negative, line.joint_compliance);
  return faces;
}

void refuse_natural_faces(TableReader& table, const std::string& expected) {
  for (const char* key : natural_keys)
    if (table.has(key)) table.refuse(key, expected);
}

}  // namespace fissura::input
