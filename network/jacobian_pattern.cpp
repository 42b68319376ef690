// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/jacobian_pattern.hpp"

#include <algorithm>

namespace fissura::network {

JacobianPattern jacobian_pattern(std::size_t nodes, std::span<const SegmentEnds> segments,
                                 std::span<const std::size_t> perforations) {
  std::vector<std::vector<int>> rows(nodes + 1);
  const auto add = [&](std::size_t row, std::size_t column) {
    rows[column].push_back(static_cast<int>(row));
  };
  for (std::size_t i = 0; i <= nodes; ++i) add(i, i);
  for (const SegmentEnds& segment : segments) {
    add(segment.a, segment.b);
    add(segment.b, segment.a);
  }
  for (const std::size_t node : perforations) {
    add(node, nodes);
    add(nodes, node);
  }

  JacobianPattern pattern;
  pattern.column_begin.push_back(0);
  for (std::vector<int>& column : rows) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    pattern.row.insert(pattern.row.end(), column.begin(), column.end());
    pattern.column_begin.push_back(static_cast<int>(pattern.row.size()));
  }

  const auto position = [&](std::size_t row, std::size_t column) {
    const auto first = pattern.row.begin() + pattern.column_begin[column];
    const auto last = pattern.row.begin() + pattern.column_begin[column + 1];
    return static_cast<std::size_t>(std::lower_bound(first, last, static_cast<int>(row)) -
                                    pattern.row.begin());
  };
  for (std::size_t i = 0; i < nodes; ++i) pattern.diagonal.push_back(position(i, i));
  for (const SegmentEnds& segment : segments) {
    pattern.row_a_col_b.push_back(position(segment.a, segment.b));
    pattern.row_b_col_a.push_back(position(segment.b, segment.a));
  }
  for (const std::size_t node : perforations) {
    pattern.row_node_col_well.push_back(position(node, nodes));
    pattern.row_well_col_node.push_back(position(nodes, node));
  }
  pattern.well = position(nodes, nodes);
  return pattern;
}

}  // namespace fissura::network
