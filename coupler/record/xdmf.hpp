// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "coupler/record/report_catalogue.hpp"

/// XDMF 2 (read by ParaView's XDMF readers and VisIt): small XML files that say where in the segments the
/// arrays lie.
namespace fissura::coupler {

/// fields.xdmf: the mesh (triangles, undeformed) with node and element values, one grid per report.
/// @pre every geometry number of a report is in `catalogue`
std::string fields_xdmf(const ReportCatalogue& catalogue);

/// fractures.xdmf: the fracture network (lines) with node and segment values, one grid per report.
/// @pre every revision of a report is in `catalogue`
std::string fractures_xdmf(const ReportCatalogue& catalogue);

/// joints.xdmf: the contact units (points) with their values, one grid per report that has any.
std::string joints_xdmf(const ReportCatalogue& catalogue);

/// Writes them into `run_directory`, each replaced as a whole; the joints only if there are any. Throws
/// StorageError.
void write_xdmf(const std::filesystem::path& run_directory, const ReportCatalogue& catalogue);

}  // namespace fissura::coupler
