// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/reference/material.hpp"

/// The reference solution of each case that has one, as the rows of its reference.csv.
namespace fissura::reference {

/// Names of the cases with a reference.csv, in alphabetical order.
std::vector<std::string> cases_with_reference();

/// Rows of cases/NAME/reference.csv, increasing in time. Throws std::invalid_argument for any other name.
std::vector<KgdState> case_table(const std::string& name);

/// The rows as CSV with a header of column names; SI units.
std::string as_csv(const std::vector<KgdState>& rows);

}  // namespace fissura::reference
