// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "structure/fracture/failure_path.hpp"
#include "tests/structure/fracture/growing_rock.hpp"

/// GrowingRock that has failed where a test wants it to.
namespace fissura::structure::fakes {

/// free_slit in rock that softens linearly in tension, with tips that grow along failure paths and
/// nucleation.
Case failing_slit();

/// Lets the elements whose centroid is `where` have lost `share` of their strength, with cracks across y; the
/// others have lost none.
void fail(GrowingRock& rock, double share, const std::function<bool(const Point&)>& where);

RockNow now(const GrowingRock& rock);
FailureMap map(const GrowingRock& rock);

}  // namespace fissura::structure::fakes
