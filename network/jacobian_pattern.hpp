// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fissura::network {

struct SegmentEnds {
  std::size_t a = 0, b = 0;

  bool operator==(const SegmentEnds&) const = default;
};

/// Where the entries of the Jacobian stand: compressed columns, rows ascending, of the nodes and, last, the
/// well. It stands as long as the graph does, so that the assembly adds straight into an array of values.
struct JacobianPattern {
  std::vector<int> column_begin;  ///< [size + 1]
  std::vector<int> row;           ///< [entries]

  std::vector<std::size_t> diagonal;           ///< position of (i, i) [nodes]
  std::vector<std::size_t> row_a_col_b;        ///< of (a, b) of every segment
  std::vector<std::size_t> row_b_col_a;        ///< of (b, a)
  std::vector<std::size_t> row_node_col_well;  ///< of every perforation
  std::vector<std::size_t> row_well_col_node;
  std::size_t well = 0;  ///< of (well, well)

  /// Number of unknowns: nodes and the well.
  [[nodiscard]] std::size_t size() const { return column_begin.size() - 1; }
  [[nodiscard]] std::size_t entries() const { return row.size(); }

  bool operator==(const JacobianPattern&) const = default;
};

/// @param perforations  the node of each; several may share one
JacobianPattern jacobian_pattern(std::size_t nodes, std::span<const SegmentEnds> segments,
                                 std::span<const std::size_t> perforations);

}  // namespace fissura::network
