// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coupler/record/hdf5_file.hpp"

namespace fissura::coupler {

/// One field report on disk.
struct FieldReport {
  std::uint64_t number = 0;
  double time = 0;             ///< [s]
  std::uint64_t geometry = 0;  ///< number of its mesh
  std::uint64_t revision = 0;  ///< topology revision of its network
};

/// The field reports in the closed segments of a run directory (docs/results.md); what a run is still writing
/// is not seen. Throws StorageError if a segment or a line of the index is not as it was written, or lacks
/// what the index promises.
class FieldReports {
 public:
  /// A directory without segments has no reports.
  explicit FieldReports(const std::filesystem::path& run_directory);

  /// In time order.
  [[nodiscard]] const std::vector<FieldReport>& all() const { return reports_; }

  /// Whether the participants of this run gave such an array, e.g. "network/aperture".
  bool has(const FieldReport& report, const std::string& array);
  /// Values of an array of report, network or mesh, row-major, of any number type.
  std::vector<double> of_report(const FieldReport& report, const std::string& array);
  std::vector<double> of_network(std::uint64_t revision, const std::string& array);
  std::vector<double> of_mesh(std::uint64_t geometry, const std::string& array);

 private:
  /// A line of the index.
  void take_in(const nlohmann::json& entry);
  std::vector<double> read(const std::string& segment, const std::string& dataset);
  Hdf5File& opened(const std::string& segment);

  std::filesystem::path folder_;
  std::vector<FieldReport> reports_;
  std::map<std::uint64_t, std::string> segment_of_report_, segment_of_mesh_, segment_of_network_;
  std::map<std::string, nlohmann::json> index_;  ///< line of each segment
  std::map<std::string, Hdf5File> open_;         ///< at most one
};

}  // namespace fissura::coupler
