// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "common/seismicity/source_record.hpp"

namespace fissura::coupler {

/// Cumulative fluid volumes of the whole thickness [m3]; see docs/protocol.md.
struct Ledger {
  double injected = 0;
  double in_place = 0;
  double found = 0;  ///< pore fluid of natural fractures that joined after the start
  double in_fractures = 0;
  double leaked = 0;
  double reset = 0;
  double residual = 0;

  /// |residual| over the largest volume that has been through the book (injected, produced, in place or
  /// found).
  double relative_residual = 0;
};

/// Greatest relative residual of a ledger that counts as balanced: the content is updated from the fluxes
/// themselves, so that only rounding may be missing.
constexpr double largest_relative_residual = 1e-10;

/// What happened on the natural fractures, all of them together; zero without any.
struct NaturalFractureFigures {
  double greatest_slip = 0;   ///< [m]
  double slipped_length = 0;  ///< trace length that slipped more than 1e-5 m [m]
  double opened_length = 0;   ///< trace length that is open [m]
  double wetted_length = 0;   ///< trace length in the fracture network [m]
  double slip_distance = 0;   ///< greatest distance of a slipped joint from a hydraulic or open fracture [m]
  double greatest_far_slip = 0;  ///< greatest slip farther than ten tip sizes from any such fracture [m]
};

/// What the rock radiated and what it did in silence, from the start on; zero without sources.
struct SeismicFigures {
  std::uint64_t events = 0;     ///< that can no longer change
  double seismic_moment = 0;    ///< sum of their scalar moments [N m]
  double greatest_moment = 0;   ///< of one event [N m]
  double aseismic_moment = 0;   ///< sum of the scalar moments of aseismic records [N m]
  double transfer_moment = 0;   ///< scalar, of what insertions changed in carrying the state over [N m]
  PlaneTensor source_moment{};  ///< of all sources, seismic or not: xx, yy, zz, xy [N m]
};

/// Everything scalar that is known at one coupling time; one line of history.csv and ledger.csv.
struct IntervalRecord {
  std::uint64_t interval = 0;  ///< coupling index
  std::uint64_t revision = 0;  ///< topology revision
  double time = 0;             ///< end of the interval [s]
  double duration = 0;         ///< [s]
  int explicit_steps = 0;      ///< of the structure in this interval
  double half_length =
      0;  ///< half the trace length between the middles of (last opened, last fully broken) node [m]
  double half_length_open = 0;    ///< half the trace length of the opened part [m]
  double half_length_broken = 0;  ///< half the trace length of the fully broken part [m]
  double inlet_aperture = 0;      ///< mechanical opening at the first perforation [m]
  double inlet_pressure = 0;      ///< total [Pa]
  double inlet_net_pressure = 0;  ///< total minus the in-situ total closure normal to the fracture there [Pa]
  double well_pressure = 0;       ///< total [Pa]
  double rate = 0;                ///< injected (+) or produced (-) at the end of the interval [m3/s]
  Ledger ledger;
  double efficiency = 1;  ///< in_fractures / (injected + in_place + found) [-]
  double mismatch =
      0;  ///< |sum l (e - e_predicted)| / sum l e over filled nodes: structure volume against content [-]
  double drift = 0;  ///< sum l |e - e_predicted| / sum l e over filled nodes [-]
  int newton_iterations = 0;
  int halvings = 0;           ///< how often the network halved the interval
  double kinetic_energy = 0;  ///< [J] with the scaled mass
  double strain_energy = 0;   ///< [J], of the change from in situ, at the last field report
  double cohesive_work = 0;   ///< spent on fracture faces so far [J]
  double failure_work = 0;    ///< spent on damage and plastic flow of the rock so far [J]
  double cohesive_share = 0;  ///< cohesive_work / (G_f times the area of the grown fracture) [-]
  double path_deviation =
      0;  ///< greatest distance of the grown fracture from the line of the perforated slit [m]
  double path_angle =
      0;  ///< greatest over the wings: angle between slit and chord from slit end to tip [rad]
  double first_angle =
      0;  ///< greatest over the wings: angle between first grown segment and greatest compression [rad]
  double end_angle = 0;  ///< the same of the mean over the last three segments [rad]
  NaturalFractureFigures natural_fractures;
  std::uint64_t meetings = 0;   ///< of a hydraulic with a natural fracture so far
  std::uint64_t crossings = 0;  ///< those of them at which the hydraulic fracture may cross
  double junction_pressure =
      0;  ///< greatest total pressure over the junctions of the network; 0 without any [Pa]
  SeismicFigures seismicity;
  std::uint64_t elements = 0;  ///< of the mesh
  double mass_scale = 1;       ///< [-]
  double stable_step = 0;      ///< [s]
};

}  // namespace fissura::coupler
