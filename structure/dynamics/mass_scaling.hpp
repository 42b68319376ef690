// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "common/byte_archive.hpp"
#include "common/case/case.hpp"

/// Staged mass scaling. A hydraulic fracture grows slowly against the waves in the rock, so masses may be
/// scaled up as long as shear waves still cross the fracture several times while it grows:
///   4 L / (c_s / sqrt(mass_scale)) <= beta t    <=>    mass_scale <= (beta t / (4 L))^2 G / density .
/// The damping adds a share of about damping * beta to the fluid pressure.
namespace fissura::structure {

/// (loading_ratio time / (4 half_length))^2 G / density  [-]; time [s], half length of the fracture [m] > 0.
double quasi_static_mass_scale(const Rock& rock, double loading_ratio, double time, double half_length);

/// Rate, pressure or fluid change at `time` [s], reached within `ramp` [s].
struct PumpEvent {
  double time = 0;
  double ramp = 0;
};

/// The mass scale through a run: it follows the pumping time, starts again from small at a change of the
/// pumping, falls at once, and grows by steps.
class MassScaling {
 public:
  /// Starts at the initial mass scale of the case.
  MassScaling(const Dynamics& dynamics, const Rock& rock);

  /// Rate, pressure or fluid change at `time` [s], reached within `ramp` [s]. To be followed by update().
  void note_pump_event(double time, double ramp);

  /// Sets the scale at a coupling time [s] for a fracture of this half length [m] > 0:
  ///   min(clamp(scale of the time since 0, initial, maximum), max(1, scale of the time since the last
  ///   event)),
  /// the latter with the event loading ratio and a time of at least the ramp. A lower value holds at once; a
  /// higher one only where it is worth a change of the step, and never more than the growth limit at a time.
  /// Returns true if the scale changed; velocities are kept.
  bool update(double time, double half_length);

  [[nodiscard]] double scale() const { return scale_; }

  /// What later scales depend on beside the case.
  void save(ByteWriter& bytes) const;
  /// Throws Error(checkpoint_unusable) if the scale cannot be one.
  void restore(ByteReader& bytes);

 private:
  [[nodiscard]] double target(double time, double half_length) const;

  Dynamics dynamics_;
  Rock rock_;
  double scale_;
  std::optional<PumpEvent> event_;
};

}  // namespace fissura::structure
