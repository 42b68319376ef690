// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "common/seismicity/source_record.hpp"
#include "coupler/seismicity/moment_tensor.hpp"

namespace fissura::coupler {

enum class EventType : std::uint8_t {
  shear = 1,    ///< C_DC > 0.6
  tensile = 2,  ///< C_ISO > 0.2 and C_CLVD > 0.2
  closing = 3,  ///< both below -0.2
  mixed = 4     ///< neither, or a tensor that is 0
};

const char* name(EventType type);

/// One event of the catalogue: sources that failed beside each other in space and time. Axes of the case.
struct SeismicEvent {
  std::uint64_t id = 0;              ///< from 1, in the order in which events closed
  double origin_time = 0;            ///< of the first record [s]
  double centroid_time = 0;          ///< weighted by the scalar moments of the records [s]
  double duration = 0;               ///< from the begin of the first to the end of the last record [s]
  std::array<double, 2> origin{};    ///< place of the first record [m]
  std::array<double, 2> centroid{};  ///< weighted by the scalar moments of the records [m]
  PlaneTensor moment{};              ///< sum over the records [N m]
  PlaneTensor pseudo_moment{};       ///< of stress changes: another quantity, see SourceRecord [N m]
  double scalar_moment = 0;          ///< of `moment` (Silver & Jordan) [N m]
  double scalar_sum = 0;             ///< sum of the scalar moments of the records [N m]
  double coherence = 0;              ///< scalar_moment / scalar_sum, 0 .. 1; 0: the records cancel [-]
  std::optional<double> magnitude;   ///< Mw; none of an event whose records cancel
  Decomposition shares;
  HudsonPoint hudson;
  double slope = 0;  ///< slope angle [rad]
  EventType type = EventType::mixed;
  std::array<double, 2> normal{};     ///< of the plane that failed, unit vector
  NodalPlane plane, auxiliary_plane;  ///< `plane` is the one that failed
  double area = 0;                    ///< of all sources, each counted once [m2]; of the bulk V / h
  double slip = 0;                    ///< mean along the plane, signed by (n_y, -n_x) [m]
  double opening = 0;                 ///< mean across it [m]
  double stress_drop = 0;             ///< loss of shear traction, mean over the area [Pa]
  double radius = 0;                  ///< root of the second moment of place, at least h / 2 [m]
  double length = 0;                  ///< extent along the plane, one element at least [m]
  double thickness = 0;               ///< length out of the plane that the moment is made with [m]
  double element_size = 0;            ///< smallest of its records [m]
  double peak_rate = 0;               ///< greatest of its records [m/s]
  double fluid_pressure = 0;          ///< mean over its records [Pa]
  double radius_of_clustering = 0;    ///< r_c that was used, greatest of its records [m]
  double time_of_clustering = 0;      ///< t_c that was used [s]
  SourceFracture fracture = SourceFracture::none;  ///< where most of the scalar moment lies
  std::uint32_t line = 0;                          ///< likewise
  std::uint64_t sources = 0;                       ///< elements and contact units
  std::uint64_t records = 0;
  std::uint64_t interval = 0;  ///< coupling index of the last record
};

}  // namespace fissura::coupler
