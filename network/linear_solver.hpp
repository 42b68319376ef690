// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "network/jacobian_pattern.hpp"

namespace fissura::network {

/// Sparse LU of the Jacobian (KLU, Davis and Palamadai Natarajan 2010). The ordering is made once per pattern
/// and the pivots are on the diagonal: columns are diagonally dominant, so it is a stable choice whatever the
/// values, and the solution depends on pattern and values alone, not on what was solved before.
class LinearSolver {
 public:
  enum class Outcome { solved, singular };

  LinearSolver();
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// Forgets everything and orders the unknowns of `pattern`. Throws SolverError if that fails.
  void set_pattern(const JacobianPattern& pattern);

  /// Solves J x = right_side in place; singular also if the values are not finite. @param values  in the
  /// order of the pattern; @pre set_pattern has been called
  [[nodiscard]] Outcome solve(std::span<const double> values, std::span<double> right_side);

  /// Numerical factorisations since the start of the program.
  [[nodiscard]] long factorisations() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fissura::network
