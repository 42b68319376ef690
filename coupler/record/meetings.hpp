// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "coupler/record/checked_file.hpp"
#include "coupler/record/table_marks.hpp"

namespace fissura::coupler {

/// A hydraulic fracture has reached a natural one: what was known, and what was decided, as the structure
/// tells it (docs/protocol.md).
struct Meeting {
  double time = 0;                                     ///< [s]
  double x = 0, y = 0;                                 ///< [m]
  std::string hydraulic, natural;                      ///< names of the lines
  double angle = 0;                                    ///< between the two, in [0, pi/2] [rad]
  double stress_xx = 0, stress_yy = 0, stress_xy = 0;  ///< local, effective, tension positive [Pa]
  double friction = 0;                                 ///< of the natural fracture [-]
  double cohesion = 0;                                 ///< the same [Pa]
  double strength = 0;                                 ///< of the rock [Pa]
  std::string criterion;                               ///< by which it was decided
  std::optional<double>
      critical_friction;  ///< least friction at which it would cross [-]; nothing if there is none
  bool crosses = false;
};

/// One entry of `meetings` of an ACKNOWLEDGE. Throws ProtocolError if a key is missing or of another type, or
/// a number is not finite.
Meeting meeting_from_json(const nlohmann::json& object);

/// One line of text for the event log.
std::string sentence(const Meeting& meeting);

/// Of a whole run.
struct MeetingTotals {
  std::uint64_t met = 0, crossed = 0;
};

/// meetings.csv: one line for each meeting. The file exists once there is one.
class MeetingLedger {
 public:
  /// @param directory  of the run
  explicit MeetingLedger(std::filesystem::path directory);

  /// Appends one line, of topology revision `revision`. Throws StorageError.
  void add(std::uint64_t revision, const Meeting& meeting);

  /// Hands all lines to the system. Throws StorageError.
  void flush();

  /// Waits until the disk has all lines and enters the mark of the table, if there is one. Throws
  /// StorageError.
  void save(TableMarks& marks, ByteWriter& archive);
  /// Goes on from there. @pre check_marks; add() was not called. Throws StorageError and
  /// Error(checkpoint_unusable).
  void resume(const TableMarks& marks, ByteReader& archive);

  [[nodiscard]] const MeetingTotals& totals() const { return totals_; }

 private:
  std::filesystem::path directory_;
  std::optional<CheckedFile> table_;
  MeetingTotals totals_;
};

}  // namespace fissura::coupler
