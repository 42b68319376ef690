// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>

#include "common/byte_archive.hpp"
#include "common/case/case.hpp"

namespace fissura::coupler {

/// What an interval showed that matters for the length of the next.
struct IntervalObservation {
  double time = 0;         ///< its end [s]
  double drift = 0;        ///< sum l |e - e^| / sum l e [-]
  double stable_step = 0;  ///< of the structure now [s]
  double half_length = 0;  ///< of the hydraulic fracture [m]
  bool inlet_closed = false;
};

/// Length of the coupling intervals: from the drift between structure and prediction, within minimum_steps
/// and maximum_steps explicit steps, and short against the time in which the front crosses one element.
class IntervalControl {
 public:
  /// @param element_size  h along the fractures [m]
  IntervalControl(const Coupling& limits, double element_size);

  /// Proposed length of the next interval [s].
  [[nodiscard]] double proposal() const { return proposal_; }

  /// After the start: the stable step is known.
  void start(double stable_step);
  void observe(const IntervalObservation& observation);
  /// Back to the shortest interval: the pumping has changed.
  void reset();

  /// Everything that later proposals depend on, and its return.
  void save(ByteWriter& bytes) const;
  void restore(ByteReader& bytes);

  /// Speed of the front over the last few elements, 0 before it has moved [m/s].
  [[nodiscard]] double front_speed() const;

 private:
  struct Front {
    double time = 0, half_length = 0;
  };
  Coupling limits_;
  double element_size_;
  double stable_step_ = 0;
  double proposal_ = 0;
  double time_ = 0;
  std::deque<Front> fronts_;  ///< the last changes of the half length
};

}  // namespace fissura::coupler
