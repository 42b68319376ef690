// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "coupler/record/interval_record.hpp"

namespace fissura::coupler {

/// One scalar of an IntervalRecord as it appears in history.csv. A new member of IntervalRecord needs one
/// here.
struct RecordedScalar {
  std::string_view name;     ///< header of the column, e.g. "half_length"
  std::string_view unit;     ///< SI; "1" without dimension
  std::string_view meaning;  ///< one line for columns.json
  double (*value)(const IntervalRecord&);
};

/// The columns of history.csv, in order.
std::span<const RecordedScalar> recorded_scalars();

/// Position of column `name` in recorded_scalars(); nothing if there is none.
std::optional<std::size_t> recorded_scalar_index(std::string_view name);

}  // namespace fissura::coupler
