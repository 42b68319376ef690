// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "common/case/case.hpp"
#include "common/seismicity/source_record.hpp"
#include "coupler/seismicity/seismic_event.hpp"

/// From records of sources to a catalogue of events: the seismic side of the coupler, without socket or file.
namespace fissura::coupler {

/// Everything the extraction needs to know of a case.
struct ExtractionControls {
  Seismicity thresholds;
  Geography geography;
  double thickness = 0;         ///< of the layer [m]
  double lame = 0, shear = 0;   ///< Lame's constants of the intact rock [Pa]
  double shear_wave_speed = 0;  ///< in the unscaled mass [m/s]
};

ExtractionControls extraction_controls(const Case& run_case);

/// What went where, of all records so far.
struct SeismicSums {
  PlaneTensor raw{};           ///< of every record [N m]
  PlaneTensor aseismic{};      ///< of records that are no part of an event [N m]
  PlaneTensor events{};        ///< of closed events [N m]
  double event_moment = 0;     ///< sum of the scalar moments of closed events [N m]
  double seismic_sum = 0;      ///< of the scalar moments of the records in closed events [N m]
  double aseismic_sum = 0;     ///< of the scalar moments of aseismic records [N m]
  double greatest_moment = 0;  ///< of a closed event [N m]
  std::uint64_t records = 0, event_count = 0;
};

/// Share of the scalar moments of all records that lies in events; none without any moment [-].
std::optional<double> seismic_fraction(const SeismicSums& sums);

/// Clusters sources in space and time. The events and every bit of their numbers depend neither on the order
/// of the records within a call, nor on how they are split over calls, nor on threads.
class Extraction {
 public:
  explicit Extraction(const ExtractionControls& controls);
  ~Extraction();
  Extraction(Extraction&&) noexcept;
  Extraction& operator=(Extraction&&) noexcept;

  /// Takes all records that end after the last call's time and up to `time` [s], in any order; they may have
  /// begun earlier. A failing one that ended earlier counts as ending at the last call's time.
  /// @returns the events that no later record can join, in the order of closing: by the latest time at which
  ///          they could have been joined
  std::vector<SeismicEvent> advance(double time, const std::vector<SourceRecord>& records);

  /// The events that are still open, as if nothing came after; nothing is open then.
  std::vector<SeismicEvent> finish();

  /// raw = aseismic + events + what is open.
  [[nodiscard]] const SeismicSums& sums() const;
  /// Of sources and clusters that are still open [N m].
  [[nodiscard]] PlaneTensor open_moment() const;

  /// Everything that later events depend on.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// Throws Error(checkpoint_unusable) if the bytes are no saved extraction.
  void restore(const std::vector<std::byte>& bytes);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace fissura::coupler
