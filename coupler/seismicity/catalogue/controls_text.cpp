// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/controls_text.hpp"

#include <fmt/format.h>

#include <span>

#include "common/hash.hpp"
#include "coupler/seismicity/catalogue/catalogue_context.hpp"

namespace fissura::coupler {

std::vector<Control> controls_of(const ExtractionControls& controls) {
  const Seismicity& t = controls.thresholds;
  return {{"slip_rate", "m/s", t.slip_rate},
          {"stress_drop", "Pa", t.stress_drop},
          {"failure_rate", "m/s", t.failure_rate},
          {"cluster_radius", "m", t.cluster_radius},
          {"cluster_time", "s", t.cluster_time},
          {"rest_time", "s", t.rest_time},
          {"thickness_equidimensional", "1", t.thickness == SourceThickness::equidimensional ? 1.0 : 0.0},
          {"thickness_of_layer", "m", controls.thickness},
          {"lame", "Pa", controls.lame},
          {"shear_modulus", "Pa", controls.shear},
          {"shear_wave_speed", "m/s", controls.shear_wave_speed}};
}

std::string controls_id(const ExtractionControls& controls) {
  constexpr std::size_t digits = 12;
  std::string text;
  for (const Control& control : controls_of(controls))
    text += fmt::format("{}={}\n", control.name, control.value);
  return sha256(std::as_bytes(std::span(text))).substr(0, digits);
}

}  // namespace fissura::coupler
