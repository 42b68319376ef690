// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coupler/seismicity/seismic_event.hpp"

namespace fissura::coupler {

/// Volume pumped so far over time, of the whole thickness.
struct InjectedVolume {
  std::vector<double> time;    ///< rising [s]
  std::vector<double> volume;  ///< [m3]
};

/// The greatest volume pumped up to `time`, linear between the times given, 0 before time 0, and held after
/// the last [m3].
double injected_until(const InjectedVolume& injected, double time);

/// Bound of the moment of one event, G dV (McGarr 2014)  [N m].
double greatest_moment_bound(double shear_modulus, double volume);

/// Bound of the sum of moments, 2 G dV (McGarr 1976)  [N m].
double moment_sum_bound(double shear_modulus, double volume);

/// Moment over time beside what the volume pumped allows; one entry a time. Sanity lines: later work disputes
/// the bounds (van der Elst et al. 2016), and they speak of shear, while a crack that opens by dV has
/// M0 >= G dV.
struct MomentBudget {
  std::vector<double> time;            ///< [s]
  std::vector<double> cumulative;      ///< scalar moments of the events up to then [N m]
  std::vector<double> greatest;        ///< of one event up to then [N m]
  std::vector<double> injected;        ///< [m3]
  std::vector<double> greatest_bound;  ///< [N m]
  std::vector<double> sum_bound;       ///< [N m]
};

/// At `times` [s], in rising order; an event counts from its centroid time on.
MomentBudget moment_budget(const std::vector<SeismicEvent>& events, const InjectedVolume& injected,
                           double shear_modulus, const std::vector<double>& times);

/// Events in equal parts of time; the rate is what lies in a part over its length.
struct EventRate {
  std::vector<double> edge;         ///< of the parts, one more than there are [s]
  std::vector<std::size_t> events;  ///< in each part
  std::vector<double> moment;       ///< sum of their scalar moments [N m]
};

/// From time 0 to `end` [s] > 0: minutes if there are at least twenty, otherwise twenty parts. By centroid
/// time; events outside count in the part next to them.
EventRate event_rate(const std::vector<SeismicEvent>& events, double end);

}  // namespace fissura::coupler
