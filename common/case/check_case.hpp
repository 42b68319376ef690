// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/case.hpp"
#include "common/case/source_value.hpp"

/// What concerns several keys of a case. A value that could not be read is not-a-number or empty in `value`,
/// and no check speaks of it; `document` tells where a key was written.
namespace fissura::input {

/// All of the checks below. Adds to `faults`.
void check_case(const Case& value, const SourceValue& document, FaultList& faults);

/// check_geometry.cpp: lines inside the domain, of positive length, without doubled points and without
/// overlap; sizes that fit; perforations on open fractures.
void check_geometry(const Case& value, const SourceValue& document, FaultList& faults);

/// check_in_situ.cpp: the boundary holds the body in x and y; the in-situ state is in equilibrium,
///   div(stress) - alpha grad(p) + density b = 0,
/// and below the tensile strength.
void check_in_situ(const Case& value, const SourceValue& document, FaultList& faults);

/// check_schedule.cpp: stages in order, from the begin of the run and within it, with known fluids; coupling,
/// an output interval that fits the run.
void check_schedule(const Case& value, const SourceValue& document, FaultList& faults);

/// check_growth.cpp: growth rules that start from failed rock have [failure] and a free path; sizes at the
/// tips and refinements fit; the in-situ state is below the Mohr-Coulomb surface,
///   s_1 - s_3 <= 2 c cos(phi) - (s_1 + s_3) sin(phi)
/// (tension positive, s_1 >= s_3; Jaeger, Cook and Zimmerman 2007, sec. 4.5), whose apex c / tan(phi) lies
/// beyond the tensile strength.
void check_growth(const Case& value, const SourceValue& document, FaultList& faults);

/// check_motion.cpp: rectangles that move at time 0 and probes inside the domain; names of probes once.
void check_motion(const Case& value, const SourceValue& document, FaultList& faults);

}  // namespace fissura::input
