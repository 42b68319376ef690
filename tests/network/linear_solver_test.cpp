// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/linear_solver.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace fissura::network;

namespace {

/// Three arms of two nodes at a seventh, the first one, and the well, which stands alone.
constexpr std::size_t nodes = 7;
const std::vector<SegmentEnds> segments{{0, 1}, {0, 2}, {0, 3}, {1, 4}, {2, 5}, {3, 6}};

/// Columns are diagonally dominant. With large columns of the outer nodes the rows of the inner ones differ
/// so much from their columns that scaled rows hide it.
std::vector<double> values(const JacobianPattern& pattern, double outer) {
  std::vector<double> entries(pattern.entries(), 0);
  const auto column = [outer](std::size_t node) { return node == 0 ? 3.3 : node < 4 ? 1.1 : outer; };
  for (std::size_t node = 0; node < nodes; ++node) entries[pattern.diagonal[node]] = column(node);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    entries[pattern.row_a_col_b[s]] = -0.45 * column(segments[s].b);
    entries[pattern.row_b_col_a[s]] = -0.3 * column(segments[s].a);
  }
  entries[pattern.well] = 1;
  return entries;
}

std::vector<double> solved(LinearSolver& solver, const JacobianPattern& pattern, double outer) {
  std::vector<double> right_side{1.0 / 3, 0.7, -1.1, 0.123, 1e3, -2e2, 5e2, 1};
  REQUIRE(solver.solve(values(pattern, outer), right_side) == LinearSolver::Outcome::solved);
  return right_side;
}

}  // namespace

TEST_CASE("linear solver: the bits of a solution do not depend on what was solved before",
          "[network][linear_solver]") {
  const JacobianPattern pattern = jacobian_pattern(nodes, segments, {});
  LinearSolver first, anew;
  first.set_pattern(pattern);
  anew.set_pattern(pattern);
  (void)solved(first, pattern, 1);
  for (const double outer : {1e4, 1e-3, 1e6}) {
    CAPTURE(outer);
    CHECK(solved(first, pattern, outer) == solved(anew, pattern, outer));
    anew.set_pattern(pattern);
  }
}
