// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "coupler/seismicity/extraction.hpp"

/// Sources with known answers, in the shale of Profit et al. (2016).
namespace fissura::coupler::test {

/// E = 32 GPa, nu = 0.2: lambda / mu = 2/3.
constexpr double shear_modulus = 32e9 / 2.4, lame_constant = shear_modulus * 2 / 3;
constexpr double thickness = 10;  // [m]

inline ExtractionControls shale_controls() {
  ExtractionControls controls;
  controls.thickness = thickness;
  controls.lame = lame_constant;
  controls.shear = shear_modulus;
  controls.shear_wave_speed = std::sqrt(shear_modulus / 2400);
  return controls;
}

/// M = A [lambda (n.d) I + mu (n d + d n)]
inline PlaneTensor moment_of_jump(double area, std::array<double, 2> n, std::array<double, 2> d, double lame,
                                  double shear) {
  const double opening = n[0] * d[0] + n[1] * d[1];
  return {area * (lame * opening + 2 * shear * n[0] * d[0]),
          area * (lame * opening + 2 * shear * n[1] * d[1]), area * lame * opening,
          area * shear * (n[0] * d[1] + n[1] * d[0])};
}

/// A joint 1 m long with normal y whose faces move by `jump` within a millisecond from `begin`; it loses 1
/// MPa of shear traction, fast enough to be heard.
inline SourceRecord joint_record(SourceKind kind, std::uint64_t entity, double begin,
                                 std::array<double, 2> position, std::array<double, 2> jump) {
  SourceRecord record;
  record.kind = kind;
  record.fracture = kind == SourceKind::contact_slip ? SourceFracture::natural : SourceFracture::grown;
  record.failing = true;
  record.entity = entity;
  record.begin = begin;
  record.end = begin + 1e-3;
  record.centroid_time = begin + 5e-4;
  record.position = position;
  record.extent = thickness;
  record.element_size = 1;
  record.normal = {0, 1};
  record.jump = jump;
  record.moment = moment_of_jump(record.extent, record.normal, jump, lame_constant, shear_modulus);
  record.peak_rate = 0.1;
  record.shear_before = 2e6;
  record.shear_after = 1e6;
  return record;
}

/// Right-lateral slip of 1 mm.
inline SourceRecord slip_record(std::uint64_t entity, double begin, std::array<double, 2> position) {
  return joint_record(SourceKind::contact_slip, entity, begin, position, {1e-3, 0});
}

/// All events of records that come in one call.
inline std::vector<SeismicEvent> events_of(const ExtractionControls& controls,
                                           const std::vector<SourceRecord>& records) {
  Extraction extraction(controls);
  double end = 0;
  for (const SourceRecord& record : records) end = std::max(end, record.end);
  std::vector<SeismicEvent> events = extraction.advance(end, records);
  for (const SeismicEvent& event : extraction.finish()) events.push_back(event);
  return events;
}

/// Every number of the events, bit for bit.
std::vector<std::byte> bytes_of(const std::vector<SeismicEvent>& events);

/// Bursts of joints and elements at random, in intervals of 10 ms that no record straddles: sizes of
/// elements, scaling of mass, class, rate and traction differ, some sources last over many intervals.
/// @returns in the order of intervals
std::vector<SourceRecord> random_records(std::uint64_t seed, int intervals);
constexpr double random_interval = 0.01;  // [s]

}  // namespace fissura::coupler::test
