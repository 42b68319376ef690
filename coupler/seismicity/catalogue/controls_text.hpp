// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupler/seismicity/extraction.hpp"

namespace fissura::coupler {

/// One number that the events depend on.
struct Control {
  std::string_view name, unit;
  double value = 0;
};

/// Thresholds, clustering and rock of an extraction, as every file of a catalogue states them: keys of
/// [seismicity] and then `thickness_of_layer`, `lame`, `shear_modulus`, `shear_wave_speed`. Zero where the
/// mesh decides (cluster_radius, cluster_time, rest_time) or nothing is left out (failure_rate);
/// `thickness_equidimensional` is 1 or 0.
std::vector<Control> controls_of(const ExtractionControls& controls);

}  // namespace fissura::coupler
