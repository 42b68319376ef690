// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "common/case/case.hpp"
#include "coupler/seismicity/extraction.hpp"

namespace fissura::coupler {

/// What a catalogue says beside its events. The files of a catalogue depend on this and the events alone.
struct CatalogueContext {
  std::string run_id;   ///< letters and digits; enters the identifiers of QuakeML
  std::string title;    ///< of the case
  std::string started;  ///< of the run, UTC; creation time of every file. Left out of them if empty
  ExtractionControls controls;
  std::optional<Georeference> georeference;
};

/// Identifies a way of making events: twelve hexadecimal digits of a hash over all controls of the
/// extraction. Two catalogues of one run with the same controls have the same, others another one.
std::string controls_id(const ExtractionControls& controls);

}  // namespace fissura::coupler
