// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/case_json.hpp"

#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/case/faults.hpp"
#include "common/case/names.hpp"
#include "common/errors.hpp"

/// A value that may be absent is null.
template <class Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
  static void to_json(json& target, const std::optional<Value>& value) {
    target = value ? json(*value) : json(nullptr);
  }
  static void from_json(const json& source, std::optional<Value>& value) {
    value = source.is_null() ? std::nullopt : std::optional(source.get<Value>());
  }
};

namespace fissura {

namespace {

template <class E, std::size_t N>
nlohmann::json word_of(E value, const std::array<Named<E>, N>& names) {
  std::string word = name_of(value, names);
  if (word.empty()) throw ProtocolError("the case holds a value of an enumeration that has no name");
  return word;
}

template <class E, std::size_t N>
E value_of(const nlohmann::json& json, const std::array<Named<E>, N>& names) {
  const std::string word = json.get<std::string>();
  for (const Named<E>& entry : names)
    if (entry.name == word) return entry.value;
  throw ProtocolError(
      fmt::format("the case says \"{}\" where one of {} is expected", word, listed(texts_of(names))));
}

}  // namespace

void to_json(nlohmann::json& json, BoundaryKind value) {
  json = word_of(value, boundary_kinds);
}
void from_json(const nlohmann::json& json, BoundaryKind& value) {
  value = value_of(json, boundary_kinds);
}
void to_json(nlohmann::json& json, FractureKind value) {
  json = word_of(value, fracture_kinds);
}
void from_json(const nlohmann::json& json, FractureKind& value) {
  value = value_of(json, fracture_kinds);
}
void to_json(nlohmann::json& json, StageControl value) {
  json = word_of(value, stage_controls);
}
void from_json(const nlohmann::json& json, StageControl& value) {
  value = value_of(json, stage_controls);
}
void to_json(nlohmann::json& json, CouplingScheme value) {
  json = word_of(value, coupling_schemes);
}
void from_json(const nlohmann::json& json, CouplingScheme& value) {
  value = value_of(json, coupling_schemes);
}
void to_json(nlohmann::json& json, Softening value) {
  json = word_of(value, softening_laws);
}
void from_json(const nlohmann::json& json, Softening& value) {
  value = value_of(json, softening_laws);
}
void to_json(nlohmann::json& json, PathRule value) {
  json = word_of(value, path_rules);
}
void from_json(const nlohmann::json& json, PathRule& value) {
  value = value_of(json, path_rules);
}
void to_json(nlohmann::json& json, TipRule value) {
  json = word_of(value, tip_rules);
}
void from_json(const nlohmann::json& json, TipRule& value) {
  value = value_of(json, tip_rules);
}

void to_json(nlohmann::json& json, CrossingRule value) {
  json = word_of(value, crossing_rules);
}
void from_json(const nlohmann::json& json, CrossingRule& value) {
  value = value_of(json, crossing_rules);
}
void to_json(nlohmann::json& json, SourceThickness value) {
  json = word_of(value, source_thicknesses);
}
void from_json(const nlohmann::json& json, SourceThickness& value) {
  value = value_of(json, source_thicknesses);
}
void to_json(nlohmann::json& json, PersistenceReading value) {
  json = word_of(value, persistence_readings);
}
void from_json(const nlohmann::json& json, PersistenceReading& value) {
  value = value_of(json, persistence_readings);
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TimeSpan, end)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Domain, width, height, thickness)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Refinement, size, west, east, south, north)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MeshControls, fracture_size, natural_size, far_size, corridor, gradation, seed, tip_size,
                                   tip_radius, tip_gradation, lattice_angle, refinements)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rock, density, youngs_modulus, poissons_ratio, tensile_strength,
                                   fracture_energy, biot_coefficient, friction_coefficient)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BulkFailure, active, softening, cohesion, friction_angle, dilation_angle,
                                   strength_across_bedding, bedding_angle, tip_exclusion)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Growth, path, tip, trigger, segment_length, turn_limit, nucleation,
                                   failure_damage, failure_length, wet_zone, crossing)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InSitu, stress, stress_gradient, pore_pressure, pore_pressure_gradient,
                                   body_acceleration)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Boundary, kind, value, ramp)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Boundaries, west, east, south, north)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FractureLine, name, kind, points, tensile_strength, fracture_energy,
                                   friction_coefficient, cohesion, dilation_angle, dilation_slip,
                                   residual_aperture, joint_compliance, set)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Scattered, mean, deviation)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NaturalFractureSet, name, orientation, spacing, length, persistence,
                                   reading, seed, west, east, south, north, faces)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Fluid, name, consistency_index, power_index, bulk_modulus)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LeakOff, coefficient, spurt_volume)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Perforation, name, position, aperture)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Stage, begin, control, rate, pressure, ramp, fluid)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Injection, perforations, stages, well_index)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Coupling, scheme, minimum_steps, maximum_steps, front_fraction,
                                   drift_tolerance, compliance_factor, maximum_interval,
                                   fracture_normal_stiffness)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Dynamics, damping, safety_factor, loading_ratio, event_loading_ratio,
                                   initial_mass_scale, maximum_mass_scale, equilibrate)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InitialVelocity, velocity, west, east, south, north)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Probe, name, position)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NetworkControls, minimum_aperture, tolerance, maximum_iterations)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Output, interval, reports_per_segment, probes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Seismicity, active, slip_rate, stress_drop, failure_rate, cluster_radius,
                                   cluster_time, rest_time, thickness, maximum_records, voxel_size,
                                   voxel_events)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Georeference, latitude, longitude, depth, start, azimuth, section_azimuth)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Deadlines, join, progress, finish)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckpointControls, interval, intervals, keep)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PressureRange, minimum, maximum)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Exchange, endpoint)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Participants, network)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Case, schema, title, time, domain, mesh, rock, bulk_failure, growth,
                                   in_situ, boundary, fractures, natural_fracture_sets,
                                   initial_velocities, fluids, leak_off, injection, coupling,
                                   dynamics, network, output, seismicity, georeference, deadlines, checkpoint,
                                   pressure_range, exchange,
                                   participants)

nlohmann::json case_to_json(const Case& value) {
  return value;
}

Case case_from_json(const nlohmann::json& json) {
  try {
    return json.get<Case>();
  } catch (const nlohmann::json::exception& error) {
    throw ProtocolError(fmt::format("the case received is not complete: {}", error.what()));
  }
}

}  // namespace fissura
