// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "common/case/case.hpp"
#include "common/case/source_value.hpp"

namespace fissura::input {

/// Effective in-plane stress xx, yy, xy at a point, tension positive [Pa].
std::array<double, 3> in_plane_stress(const InSitu& in_situ, const Point& point);

/// Warns if natural fractures do not hold in situ,  |tau| > c - mu sigma_n  with tension positive (Jaeger,
/// Cook and Zimmerman 2007, ch. 3): the first of them is named.
void warn_of_slip_in_situ(const Case& value, const SourceValue& document, FaultList& warnings);

}  // namespace fissura::input
