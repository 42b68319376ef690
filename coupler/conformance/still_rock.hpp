// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "coupler/conformance/driver.hpp"

namespace fissura::coupler::conformance {

/// A rock that measures the same in every interval, whatever the fluid does: the law of content and the
/// conductances stand still, so that balances and steady flow have closed forms.
struct StillRock {
  double aperture = 1e-4;         ///< measured [m]
  double compliance = 0;          ///< [m/Pa]
  double reference_pressure = 0;  ///< [Pa]
  unsigned char closed = 0;       ///< 1 where the faces touch

  /// e(p) of flow_solvers.md (3b) [m]. @param pressure >= 0 [Pa]
  [[nodiscard]] double aperture_at(double pressure) const;
  /// m of (3c), of a node that is filled [m].
  [[nodiscard]] double content_at(double pressure, double bulk_modulus) const;
  /// The p >= 0 of (3c) at which a filled node has `content` [Pa]; 0 if it is not filled. With
  /// m = (A + c p)(1 + p / K), A the aperture at p = 0, it is the positive root of a quadratic.
  [[nodiscard]] double pressure_of(double content, double bulk_modulus) const;
};

/// One process of the candidate between such faces.
class StillScene {
 public:
  StillScene(const Candidate& candidate, const Case& run_case, const Insertion& first, const StillRock& rock);

  const FlowAnswer& advance(double duration);
  /// @returns the last answer
  const FlowAnswer& advance_many(int count, double duration);
  /// Advances by six intervals, each a hundred times the slowest time constant of a slit without a way out
  /// whose segments conduct as `conducting` apart [m]: what is left of differences is below 1e-9, by whatever
  /// steps.
  const FlowAnswer& come_to_rest(double conducting);
  /// New nodes stand as `rock` says, too.
  void insert(const Insertion& insertion);
  /// Lengths of all nodes together [m].
  [[nodiscard]] double length() const;

  Driver driver;
  StillRock rock;
  CouplingInterval asked;  ///< of the next interval, but for its times; a check may change it
  double time = 0;         ///< of the end of the last interval [s]
  FlowAnswer last;

 private:
  void ask_all();
};

/// Water pumped at `rate` [m3/s, whole thickness] from 0 to `end` [s], then shut in.
Case puff(double rate, double end);

/// A slit that is pumped at its west end and runs out at its east end into a basin: a new, empty node so long
/// that it never fills, whose pressure therefore is 0. The node arrays are in the order from west to east.
class OpenSlit : public StillScene {
 public:
  static constexpr std::size_t nodes = 6;  ///< the basin is the last
  static constexpr double spacing = 0.5;   ///< [m]

  /// `rock` of the slit must not be empty.
  OpenSlit(const Candidate& candidate, const Case& run_case, const StillRock& rock);
  /// Advances until nothing changes any more: far more than the time in which a change of pressure in water
  /// runs through a rigid slit.
  const FlowAnswer& settle();
};

/// Appends a basin to node `from` (an index) of the network, which the segment reaches over `spacing` [m].
/// It must be a tip; its length stays what it is, so that it stays full.
Insertion basin(const FractureNetwork& network, std::size_t from, double spacing, double time);

}  // namespace fissura::coupler::conformance
