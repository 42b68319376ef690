// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupler/record/checked_file.hpp"
#include "coupler/record/table_marks.hpp"

namespace fissura::coupler {

/// What a probe saw at one coupling time, as the structure tells it (docs/protocol.md).
struct ProbeValues {
  double stress_xx = 0, stress_yy = 0,
         stress_xy = 0;  ///< effective, tension positive, in situ and change together [Pa]
  double displacement_x = 0, displacement_y = 0;  ///< [m]
  std::optional<double> slip, opening;  ///< of the nearest joint; nothing without one within an element [m]
  std::optional<double> normal_traction, shear_traction;  ///< effective contact there, tension positive [Pa]
};

/// One entry of `probes` of a RESPONSE. Throws ProtocolError if a key is missing or of another type.
ProbeValues probe_values_from_json(const nlohmann::json& object);

/// One quantity of a probe.
struct ProbeQuantity {
  std::string_view name;  ///< "stress_xx" and so on: the members of ProbeValues
  std::string_view unit;  ///< SI
  std::optional<double> (*value)(const ProbeValues&);
};

/// The quantities of every probe, in the order of their columns.
std::span<const ProbeQuantity> probe_quantities();

/// probes.csv: `time` [s] and, for each probe, the columns NAME.quantity, one line for each coupling time.
/// What a probe did not see, or a structure did not tell, is nan.
class ProbeSeries {
 public:
  /// @param names  of the probes, in the order of the case
  explicit ProbeSeries(const std::vector<std::string>& names);

  /// Creates the file if there is a probe. Throws StorageError.
  void write_to(const std::filesystem::path& directory);

  /// Appends one coupling time. `probes`: one entry for each probe, or none from a structure that tells
  /// nothing. Throws ProtocolError for another number, and StorageError.
  void add(double time, const std::vector<ProbeValues>& probes);

  /// Hands all lines to the system. Throws StorageError.
  void flush();

  /// Waits until the disk has all lines and enters the mark of the table, if there is one. Throws
  /// StorageError.
  void save(TableMarks& marks);
  /// In place of write_to(): see History::resume.
  void resume(const std::filesystem::path& directory, const TableMarks& marks);

  /// The values of `probe.NAME.quantity` at all coupling times, or of `probe.NAME.quantity_change`: the same
  /// minus its first value. Nothing if there is no such probe or quantity.
  [[nodiscard]] std::optional<std::span<const double>> series(std::string_view name) const;

 private:
  void keep(std::size_t quantity, double value);

  std::vector<std::string> names_;
  std::vector<std::vector<double>> values_;  ///< [probe x quantity, then its change]
  std::map<std::string, std::size_t, std::less<>> columns_;
  std::optional<CheckedFile> table_;
};

/// A name that ProbeSeries::series() knows, and its unit.
struct ProbeColumn {
  std::string name;
  std::string_view unit;
};

/// All of them, for probes of these names.
std::vector<ProbeColumn> probe_columns(const std::vector<std::string>& names);

}  // namespace fissura::coupler
