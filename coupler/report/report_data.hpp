// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace fissura::coupler {

/// Everything the page shows, from the files of a run directory (docs/results.md) alone. The run may have
/// ended, failed, been killed, or still be going on: what is on disk and whole is shown.
///   run, case       run.json, effective_case.json
///   summary         summary.json; null if the run has not ended
///   columns         columns.json
///   history, ledger {"rows": lines of the file, "columns": {name: values as in the file}}, thinned alike if
///                   the run is long
///   remeshing       the same of remeshing.csv; null if the mesh never changed
///   comparison      comparison.hpp; "classical" there, too
///   map, joints     fracture_map.hpp, joint_map.hpp
///   meetings        meetings.csv, as remeshing; null if no natural fracture was met
///   seismicity      seismic_data.hpp; null without an event
///   stress          stress_crosses.hpp; null where no report has it
///   least_stress, relative_stress  stress_maps.hpp: of the whole fracture, and of the whole domain
///   in_situ         total principal stresses at the origin, compression positive [Pa]: "greatest", "least",
///                   and the "angle" of the greatest, counter-clockwise from x [rad]
/// Numbers that are not finite are null. Throws Error(precondition) if it is not a run directory, InputError
/// or StorageError if a file is damaged.
nlohmann::json report_data(const std::filesystem::path& run_directory);

}  // namespace fissura::coupler
