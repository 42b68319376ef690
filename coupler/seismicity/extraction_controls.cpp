// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "coupler/seismicity/extraction.hpp"

namespace fissura::coupler {

namespace {

Geography plan_view(double azimuth_of_y) {
  const double c = std::cos(azimuth_of_y), s = std::sin(azimuth_of_y);
  return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}

Geography section(double azimuth_of_x) {
  const double c = std::cos(azimuth_of_x), s = std::sin(azimuth_of_x);
  return {{s, 0, c}, {c, 0, -s}, {0, 1, 0}};
}

Geography geography_of(const std::optional<Georeference>& georeference) {
  if (!georeference) return {};
  if (georeference->section_azimuth) return section(*georeference->section_azimuth);
  return plan_view(georeference->azimuth);
}

}  // namespace

ExtractionControls extraction_controls(const Case& run_case) {
  const Rock& rock = run_case.rock;
  ExtractionControls controls;
  controls.thresholds = run_case.seismicity;
  controls.geography = geography_of(run_case.georeference);
  controls.thickness = run_case.domain.thickness;
  controls.shear = rock.shear_modulus();
  controls.lame = 2 * controls.shear * rock.poissons_ratio / (1 - 2 * rock.poissons_ratio);
  controls.shear_wave_speed = std::sqrt(controls.shear / rock.density);
  return controls;
}

}  // namespace fissura::coupler
