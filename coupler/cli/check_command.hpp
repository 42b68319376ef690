// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "common/case/read_case.hpp"

namespace fissura::coupler {

/// `coupler check`: every fault of case and expectations (thrown as CaseFaults), or the warnings and the derived numbers on standard
/// output. @returns the exit code
int check_command(const CaseSource& source);

}  // namespace fissura::coupler
