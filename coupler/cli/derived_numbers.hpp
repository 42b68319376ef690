// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "common/case/case.hpp"

namespace fissura::coupler {

/// A number that follows from a case, for the eyes of its author.
struct DerivedNumber {
  std::string name;
  double value = 0;
  std::string unit;
  std::string remark;
};

/// Moduli, toughness, cohesive zone against element size, regime of the fracture, waves, stable step, steps of the run.
///   K_m = (K'^4 / (mu' Q E'^3))^(1/4) with K' = sqrt(32/pi) K_Ic, mu' = 12 mu   (Detournay 2004); Newtonian rate stages only
std::vector<DerivedNumber> derived_numbers(const Case& run_case);

}  // namespace fissura::coupler
