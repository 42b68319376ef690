// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fissura::coupler {

/// `coupler seismicity`, as typed. What is not given stays as in the case of the run.
struct SeismicityOptions {
  std::filesystem::path run_directory;
  /// Numbers with units, e.g. "3 m"; keys of [seismicity].
  std::optional<std::string> cluster_radius, cluster_time, rest_time, slip_rate, stress_drop, failure_rate;
  std::optional<std::string> thickness;            ///< "layer" or "equidimensional"
  std::optional<double> minimum_magnitude;         ///< smaller events are left out of points and QuakeML
  std::vector<std::string> formats;                ///< csv, hdf5, points, quakeml; empty: all possible ones
  std::optional<std::filesystem::path> directory;  ///< default: seismicity_rebuilt in the run directory
};

/// Makes the catalogue of a run again from the records of sources in its closed segments, writes it and
/// prints what is in it. With unchanged thresholds its events are those of the run, every bit. The run is
/// only read. Throws Error. @returns the exit code
int seismicity_command(const SeismicityOptions& options);

}  // namespace fissura::coupler
