// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "coupler/seismicity/analysis/fronts.hpp"
#include "coupler/seismicity/seismic_event.hpp"

namespace fissura::coupler {

/// A curve of distance [m] over time of the run [s].
struct DistanceCurve {
  std::vector<double> time, distance;
};

/// How a front could grow.
struct GrowthLaw {
  std::string name;                   ///< "diffusion", "KGD", "PKN"
  std::string meaning;                ///< in words
  PowerLaw law;                       ///< its exponent is that of the law; time from the start of pumping
  std::optional<double> diffusivity;  ///< D of the triggering front; only of diffusion [m2/s]
  double misfit = 0;                  ///< of the envelope, fronts.hpp [-]
  DistanceCurve curve;
};

/// Distance of events from the well over time.
struct DistanceTime {
  std::vector<double> distance;   ///< of the centroid of each event from the nearest perforation [m]
  Point well{};                   ///< mean of the perforations [m]
  double start = 0;               ///< of pumping [s]
  std::optional<double> shut_in;  ///< first one after it [s]
  DistanceCurve envelope;         ///< 95 % of the distances, between start and shut-in
  std::optional<PowerLaw> fit;    ///< of the envelope; time from the start. None from fewer than 3 points
  std::vector<GrowthLaw> laws;    ///< empty without an envelope
  std::optional<std::size_t> nearest;  ///< law of the least misfit; none without a fit
  bool fits = false;    ///< the fitted exponent is that of the nearest law within its uncertainty
  std::string verdict;  ///< a sentence; the fitted exponent stands beside it
  std::optional<DistanceCurve> back_front;  ///< of the diffusivity, in two dimensions, after shut-in
};

/// Distances count from the nearest perforation: each of several feeds a fracture of its own.
///
/// The envelope: events between start of pumping and first shut-in are sorted by centroid time and split into
/// groups of equal number, 20 events each, but at least 8 and at most 40 groups; of each group the event
/// whose distance is exceeded by at most 5 % of the group (nearest rank) gives a point, with its own time. So
/// events that lie on a curve give points of that curve.
///
/// The laws: t^1/2 (diffusion of pore pressure; also a fracture governed by leak-off), t^2/3 (KGD) and t^4/5
/// (PKN), both without leak-off. The nearest has the least misfit; it fits if its exponent differs from the
/// fitted one by at most two standard errors or 0.03, what a law can be told from its neighbour by. Nothing
/// of a dry case.
std::optional<DistanceTime> distance_time(const std::vector<SeismicEvent>& events, const Case& run_case);

}  // namespace fissura::coupler
