// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/case/faults.hpp"
#include "common/natural_fractures/natural_network.hpp"

/// From a case folder to the typed case. The keys, units and defaults are in docs/case_format.md.
namespace fissura {

struct CaseSource {
  std::filesystem::path path;         ///< of the case folder, or of its case.toml
  std::vector<std::string> variants;  ///< NAME.toml of the folder is laid over case.toml, one after the other
  std::vector<std::string> overrides;  ///< "KEY.PATH=VALUE" each, applied last and in order
};

struct CaseReading {
  Case value;
  FaultList warnings;                        ///< values that are allowed but hardly meant
  NaturalFractureReport natural_fractures;   ///< how those of the case were drawn and cleaned
  std::filesystem::path folder;              ///< of the case
  std::vector<std::filesystem::path> files;  ///< everything that was read, for the record of the run
};

/// Reads and checks a case; opens files for reading only, and only in the case folder. Throws CaseFaults with
/// every fault of the case. Stresses become tension positive and the principal horizontal stresses
/// components:
///   s_xx = m - d cos 2a,  s_yy = m + d cos 2a,  s_xy = d sin 2a
/// with m and d the mean and half the difference of maximum and minimum, and a the azimuth of the maximum
/// from north (y), clockwise (rotation of the stress tensor, e.g. Jaeger, Cook and Zimmerman 2007, sec. 2.3).
CaseReading read_case(const CaseSource& source);

}  // namespace fissura
