// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"
#include "common/case/source_value.hpp"

namespace fissura::input {

/// Values that a case may have but that no rock, fluid or treatment has: most often a prefix of a unit gone
/// wrong. The windows are wide, a decade or more beyond the ranges of rock mechanics handbooks (e.g. Jaeger,
/// Cook and Zimmerman 2007) and of fracturing practice (Economides and Nolte 2000). One warning for all
/// natural fractures that slip in situ, |tau| > c - mu sigma_n (tension positive): they come to rest at
/// another stress before time 0.
FaultList implausible_values(const Case& value, const SourceValue& document);

}  // namespace fissura::input
