// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "common/seismicity/source_record.hpp"

namespace fissura::structure {

struct SourceRecords {
  std::vector<SourceRecord> records;  ///< sorted by comes_before()
  std::size_t merged = 0;             ///< records that went into others
};

/// At most `most` records with the same sum of moments: more are merged with their neighbours, which are the
/// next ones in number of the same kind on the same line, failing ones with failing ones. A merged record
/// keeps the lowest entity, the greatest element size and peak rate, begin and end of all; moments and
/// extents are summed, place and centroid time weighted by the size of the moments, the rest by extent. There
/// are never fewer than one for each line and kind.
SourceRecords merged(std::vector<SourceRecord> records, std::size_t most);

}  // namespace fissura::structure
