// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "coupler/conformance/driver.hpp"

namespace fissura::coupler::conformance {

/// A rock of independent springs: the faces at a node stand `aperture` apart without pressure and open by
/// `compliance` times the pressure. It follows what the solver predicted exactly, as a structure without
/// inertia would.
struct Springs {
  double aperture = 1e-4;     ///< [m]
  double compliance = 1e-10;  ///< [m/Pa]
};

/// The interval that springs under `pressure` (of each node; 0 for nodes beyond its length) ask for [Pa].
CouplingInterval spring_interval(const Springs& springs, const FractureNetwork& network, double begin,
                                 double end, const std::vector<double>& pressure);

/// The plain scene of most checks: a slit of nine nodes in springs, water pumped into its middle, interval by
/// interval.
class PumpedSlit {
 public:
  static constexpr std::size_t nodes = 9;
  static constexpr double spacing = 0.5;   ///< [m]
  static constexpr double duration = 0.1;  ///< of an interval [s]
  static constexpr double rate = 2e-4;     ///< [m3/s], whole thickness

  /// Pumped from 0 to the end.
  explicit PumpedSlit(const Candidate& candidate);
  /// Another case, another first topology.
  PumpedSlit(const Candidate& candidate, const Case& run_case, const Insertion& first);

  /// One more interval. @returns its answer, which `last` keeps
  const FlowAnswer& advance() { return advance(duration); }
  const FlowAnswer& advance(double length);
  void advance_many(int count);
  /// The next one, not yet asked for.
  [[nodiscard]] CouplingInterval next(double length) const;

  Driver driver;
  Springs springs;
  double time = 0;  ///< of the end of the last interval [s]
  FlowAnswer last;
};

/// The case of the plain scene.
Case pumped_case();

}  // namespace fissura::coupler::conformance
