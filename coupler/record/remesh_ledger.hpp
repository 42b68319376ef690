// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "coupler/record/checked_file.hpp"
#include "coupler/record/table_marks.hpp"

namespace fissura::coupler {

/// What one inserted segment did to the mesh, as the structure tells it (docs/protocol.md).
struct Remeshing {
  std::string fracture;  ///< name of the line that grew
  double x = 0, y = 0;   ///< the new tip [m]
  std::uint64_t elements_removed = 0, elements_made = 0, elements_untouched = 0;
  std::string hash_before, hash_after;                         ///< of the untouched elements and their nodes
  double smallest_angle = 0;                                   ///< of the elements made [rad]
  double smallest_altitude = 0;                                ///< of the elements made [m]
  double stable_step_before = 0, stable_step_after = 0;        ///< [s]
  double strain_energy_before = 0, strain_energy_after = 0;    ///< of the patch [J]
  double kinetic_energy_before = 0, kinetic_energy_after = 0;  ///< of the patch [J]
  double mass_error = 0;                                       ///< relative [-]
  double momentum_error = 0;                                   ///< relative to the sum of |m v| [-]
  double wall_seconds = 0;

  /// The greater of removed and made.
  [[nodiscard]] std::uint64_t touched() const;
};

/// One entry of `remeshing` of an ACKNOWLEDGE. Throws ProtocolError if a key is missing or of another type,
/// or a number is not finite.
Remeshing remeshing_from_json(const nlohmann::json& object);

/// Of a whole run.
struct RemeshTotals {
  std::uint64_t insertions = 0;  ///< inserted segments that remeshed
  double median_touched = 0;
  std::uint64_t largest_touched = 0;
  bool untouched_identical = true;                            ///< every hash after is the one before
  double smallest_angle = 0;                                  ///< [rad]; 0 without insertions
  double wall = 0;                                            ///< [s]
  double largest_mass_error = 0, largest_momentum_error = 0;  ///< magnitudes [-]
  double smallest_step_ratio = 1;                             ///< least of stable step after / before [-]
  double strain_energy_jump = 0;  ///< sum of after - before, once per revision [J]
};

/// remeshing.csv, one line for each inserted segment, and the totals; remeshing_wall.csv, the wall times of
/// the same lines, apart because they alone differ from run to run. The files exist once the mesh has
/// changed.
class RemeshLedger {
 public:
  /// @param directory  of the run
  explicit RemeshLedger(std::filesystem::path directory);

  /// Appends one line, of topology revision `revision` at `time` [s]. Throws StorageError.
  void add(std::uint64_t revision, double time, const Remeshing& remeshing);

  /// Hands all lines to the system. Throws StorageError.
  void flush();

  /// Waits until the disk has all lines and enters the marks of the tables, if there are any. Throws
  /// StorageError.
  void save(TableMarks& marks, ByteWriter& archive);
  /// Goes on from there. @pre check_marks; add() was not called. Throws StorageError and
  /// Error(checkpoint_unusable).
  void resume(const TableMarks& marks, ByteReader& archive);

  [[nodiscard]] RemeshTotals totals() const;

 private:
  std::filesystem::path directory_;
  std::optional<CheckedFile> table_, wall_times_;
  std::vector<std::uint64_t> touched_;
  RemeshTotals totals_;
  std::optional<std::uint64_t> last_revision_;
};

}  // namespace fissura::coupler
