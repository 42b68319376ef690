// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"
#include "common/seismicity/source_record.hpp"
#include "coupler/seismicity/compensated_sum.hpp"

/// Sources: what one element or contact unit did without a rest.
namespace fissura::coupler {

/// Sources of different classes never make one event.
enum class SourceClass : std::uint8_t { tensile = 0, shear = 1 };

constexpr SourceClass class_of(SourceKind kind) {
  return kind == SourceKind::bulk_shear || kind == SourceKind::contact_slip ? SourceClass::shear
                                                                            : SourceClass::tensile;
}

/// Which element or contact unit; elements only within one geometry, contact units keep their numbers.
struct Entity {
  std::uint64_t number = 0;
  std::uint64_t geometry = 0;  ///< 0 of contact units
  std::uint32_t bulk = 0;      ///< 1 of elements

  friend auto operator<=>(const Entity&, const Entity&) = default;
};

Entity entity_of(const SourceRecord& record);

/// One source. Without gaps between the members: it is saved bit for bit.
struct Source {
  PlaneTensor moment{};              ///< sum over its records [N m]
  PlaneTensor pseudo_moment{};       ///< [N m]
  double scalar_sum = 0;             ///< of the scalar moments of its records [N m]
  double time = 0;                   ///< of the ends of its records, weighted by those [s]
  double centroid_time = 0;          ///< of the centroid times of its records, likewise [s]
  double reach = 0;                  ///< time + t_c: latest time of a later source that it joins [s]
  std::array<double, 2> position{};  ///< of the first record [m]
  double begin = 0, end = 0;         ///< [s]
  std::array<double, 3> plane{};     ///< sum of scalar moment times n n^T: xx, yy, xy [N m]
  double slip = 0, opening = 0;      ///< along and across the plane [m]
  double area = 0;                   ///< [m2]
  double length = 0;                 ///< along the plane [m]
  double shear_before = 0;           ///< of the first record [Pa]
  double shear_after = 0;            ///< of the last record [Pa]
  double pressure_sum = 0;           ///< over its records [Pa]
  double peak_rate = 0;              ///< [m/s]
  double smallest_size = 0;          ///< of the elements [m]
  double greatest_size = 0;          ///< of the elements [m]
  double mass_scale = 1;             ///< greatest [-]
  double cluster_radius = 0;         ///< r_c [m]
  double cluster_time = 0;           ///< t_c [s]
  std::uint64_t number = 0, geometry = 0, interval = 0;
  std::uint32_t records = 0;
  std::uint32_t line = 0;
  std::uint32_t bulk = 0;
  SourceClass source_class = SourceClass::tensile;
  SourceFracture fracture = SourceFracture::none;
  std::uint8_t contact = 0;  ///< 1: of touching faces that slid
  std::uint8_t unused = 0;

  [[nodiscard]] Entity entity() const { return {number, geometry, bulk}; }
  [[nodiscard]] double shear_drop() const { return std::abs(shear_before) - std::abs(shear_after); }
};

/// Whether a saved source can be one: finite numbers, times in order, sizes that lengths of a mesh can have,
/// words that there are. `cluster_radius` and what follows from it are looked at only if the source is
/// complete.
enum class SourceStage { going_on, complete };
bool is_possible(const Source& source, SourceStage stage);

/// Order in which sources are taken: by time, then entity, class and begin; no two are equal.
bool comes_before(const Source& a, const Source& b);

/// What makes records into sources and says how far and how long these reach.
struct SourceRules {
  Seismicity thresholds;
  double thickness = 0;         ///< [m]
  double lame = 0, shear = 0;   ///< [Pa]
  double shear_wave_speed = 0;  ///< in the unscaled mass [m/s]

  /// Whether the record can be part of an event: it failed, and faster than the rate for its kind. Rates are
  /// those of the rock's own mass, peak_rate * sqrt(mass_scale).
  [[nodiscard]] bool seismic(const SourceRecord& record) const;

  /// Whether a source that is complete is one: slip of touching faces must have cost shear traction.
  [[nodiscard]] bool seismic(const Source& source) const;

  /// r_c: cluster_radius, or 1.5 element sizes  [m]
  [[nodiscard]] double cluster_radius(double element_size) const;

  /// t_c: cluster_time, or the time of a shear wave over r_c in the scaled mass  [s]
  [[nodiscard]] double cluster_time(double element_size, double mass_scale) const;

  /// rest_time, or a hundred t_c  [s]
  [[nodiscard]] double rest_time(double element_size, double mass_scale) const;

  /// Longest time beyond the rest after which a record still counts that began before: slow motion is told of
  /// when it has come to something. A hundred passages of a shear wave over 1.5 element sizes, some twenty
  /// coupling intervals  [s]
  [[nodiscard]] double telling_time(double element_size, double mass_scale) const;
};

/// A source that may still go on.
class OpenSource {
 public:
  OpenSource() = default;  ///< to be read from a saved one
  OpenSource(const SourceRecord& first, const SourceRules& rules);

  /// @pre `record` comes after all others of this entity and class
  void add(const SourceRecord& record, const SourceRules& rules);

  /// Whether the record is its continuation.
  [[nodiscard]] bool goes_on_in(const SourceRecord& record) const {
    return record.begin <= goes_on_until_ && listens_at(record.end);
  }
  /// Whether a record that ends then can be.
  [[nodiscard]] bool listens_at(double end) const { return end <= listens_until_; }
  [[nodiscard]] double listens_until() const { return listens_until_; }
  /// Its time will not be earlier [s].
  [[nodiscard]] double first_end() const { return first_end_; }
  [[nodiscard]] Entity entity() const { return source_.entity(); }
  [[nodiscard]] SourceClass source_class() const { return source_.source_class; }
  [[nodiscard]] PlaneTensor moment() const { return moment_.value(); }

  /// Whether it can have been saved by an OpenSource; all others must not be used.
  [[nodiscard]] bool is_possible() const;

  /// The source as it is now.
  [[nodiscard]] Source closed(const SourceRules& rules) const;

 private:
  Source source_;
  TensorSum moment_, pseudo_moment_;
  CompensatedSum scalar_sum_, weighted_end_, weighted_centroid_;  // times from the first end
  double first_end_ = 0;
  double goes_on_until_ = 0;  // end + rest time
  double listens_until_ = 0;  // that + telling time
};

}  // namespace fissura::coupler
