// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/exchange/message.hpp"

/// What the structure tells of rock and faces that failed: the raw material of the seismic catalogue. All
/// moments are of the whole thickness of the model, components in the axes of the case (x, y in the plane, z
/// across it).
namespace fissura {

/// Numbers of the wire and of the files; never reuse one.
enum class SourceKind : std::uint8_t {
  bulk_tension = 1,     ///< element that cracked
  bulk_shear = 2,       ///< element that flowed
  bulk_compaction = 3,  ///< element that flowed and lost volume
  contact_slip = 4,     ///< touching faces that slid
  contact_opening = 5,  ///< faces without cohesion that moved apart or together
  new_crack = 6         ///< faces that moved while their cohesion wore off
};

constexpr bool in_bulk(SourceKind kind) {
  return kind <= SourceKind::bulk_compaction;
}

/// On which kind of fracture a source lies; numbers of the wire.
enum class SourceFracture : std::uint8_t { open = 0, natural = 1, grown = 2, none = 255 };

/// A symmetric tensor of plane strain, xz = yz = 0. xx, yy, zz, xy.
using PlaneTensor = std::array<double, 4>;

/// What one element or one pair of faces (a contact unit) did in one coupling interval or, if it did not
/// fail, since it was last told of.
struct SourceRecord {
  SourceKind kind = SourceKind::contact_opening;
  SourceFracture fracture = SourceFracture::none;
  /// Its inelastic measure grew: damage, plastic strain, slip of touching faces, separation of faces with
  /// cohesion. Otherwise it opened or closed along a path that it can go back.
  bool failing = false;
  std::uint32_t line = 0;            ///< of the fracture, in the order of the mesh's lines; 0 in the bulk
  std::uint64_t entity = 0;          ///< element, or contact unit: two countings of their own
  std::uint64_t interval = 0;        ///< coupling index
  std::uint64_t geometry = 0;        ///< number of the mesh; elements have other numbers in another one
  double begin = 0;                  ///< of the first step in which it changed [s]
  double end = 0;                    ///< of the last one [s]
  double centroid_time = 0;          ///< of the changes, weighted by their size, within begin and end [s]
  std::array<double, 2> position{};  ///< [m]
  double extent = 0;                 ///< area of the faces [m2]; in the bulk volume of the element [m3]
  double element_size = 0;           ///< edge length of the mesh there [m]
  std::array<double, 2> normal{};    ///< from minus to plus, unit vector; in the bulk of the crack band
  std::array<double, 2> jump{};      ///< change of u_plus - u_minus [m]; 0 in the bulk
  PlaneTensor moment{};              ///< stress glut [N m]
  /// Minus the change of effective stress times volume; of faces that of a band one element wide [N m].
  PlaneTensor pseudo_moment{};
  double measure = 0;  ///< growth of the inelastic measure: damage, plastic strain [-], slip, separation [m]
  /// Greatest rate of the jump while failing, with scaled masses; in the bulk band length times the rate of
  /// the inelastic strain [m/s].
  double peak_rate = 0;
  /// Shear traction on the plane at begin and end, effective, signed by the tangent (n_y, -n_x) [Pa].
  double shear_before = 0, shear_after = 0;
  /// Normal traction there, effective, tension positive [Pa].
  double normal_before = 0, normal_after = 0;
  double fluid_pressure = 0;  ///< at the end [Pa]
  double mass_scale = 1;      ///< of the interval [-]

  friend bool operator==(const SourceRecord&, const SourceRecord&) = default;
};

/// Order in which sums over records are formed, whatever the order they arrived in: end of the record, then
/// bulk before faces, entity, kind, begin.
bool comes_before(const SourceRecord& a, const SourceRecord& b);

/// The records as named arrays, one row a record, for messages and files: `source_kind`, `source_time` [n x
/// 3: begin, end, centroid], ...; docs/protocol.md lists them. Lossless. No array without records.
std::vector<Array> arrays_of(const std::vector<SourceRecord>& records);

/// The records in such arrays; arrays of other names are passed over. No record if there is none of them.
/// Throws ProtocolError if an array is missing, of another type or length, or holds an unknown kind;
/// ValueError if a value is not finite.
std::vector<SourceRecord> records_of(const std::vector<Array>& arrays);

}  // namespace fissura
