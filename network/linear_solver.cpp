// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/linear_solver.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <klu.h>

#include "common/errors.hpp"

namespace fissura::network {

class LinearSolver::Implementation {
 public:
  Implementation() {
    klu_defaults(&common_);
    // Always the diagonal. A pivot off it would be chosen by the values of the first factorisation and kept, and with it the
    // bits would depend on the history: on whether the run was resumed since.
    common_.btf = 0;
    common_.tol = 0;
  }
  ~Implementation() { clear(); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void set_pattern(const JacobianPattern& pattern) {
    clear();
    column_begin_ = pattern.column_begin;
    row_ = pattern.row;
    symbolic_ = klu_analyze(size(), column_begin_.data(), row_.data(), &common_);
    if (symbolic_ == nullptr) throw SolverError("the unknowns of the fracture network could not be ordered");
  }

  Outcome solve(std::span<const double> values, std::span<double> right_side) {
    if (!factorise(values)) return Outcome::singular;
    klu_solve(symbolic_, numeric_, size(), 1, right_side.data(), &common_);
    const bool finite =
        std::all_of(right_side.begin(), right_side.end(), [](double x) { return std::isfinite(x); });
    return finite ? Outcome::solved : Outcome::singular;
  }

  [[nodiscard]] long factorisations() const { return factorisations_; }

 private:
  [[nodiscard]] int size() const { return static_cast<int>(column_begin_.size()) - 1; }

  bool factorise(std::span<const double> values) {
    ++factorisations_;
    // KLU does not write to the values.
    auto* entries = const_cast<double*>(values.data());
    if (numeric_ != nullptr) {
      if (klu_refactor(column_begin_.data(), row_.data(), entries, symbolic_, numeric_, &common_) != 0 &&
          common_.status == KLU_OK)
        return true;
      klu_free_numeric(&numeric_, &common_);
    }
    numeric_ = klu_factor(column_begin_.data(), row_.data(), entries, symbolic_, &common_);
    if (numeric_ == nullptr) return false;
    if (common_.status == KLU_OK) return true;
    klu_free_numeric(&numeric_, &common_);
    return false;
  }

  void clear() {
    if (numeric_ != nullptr) klu_free_numeric(&numeric_, &common_);
    if (symbolic_ != nullptr) klu_free_symbolic(&symbolic_, &common_);
  }

  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  std::vector<int> column_begin_, row_;
  long factorisations_ = 0;
};

LinearSolver::LinearSolver() : implementation_(std::make_unique<Implementation>()) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::set_pattern(const JacobianPattern& pattern) {
  implementation_->set_pattern(pattern);
}

LinearSolver::Outcome LinearSolver::solve(std::span<const double> values, std::span<double> right_side) {
  return implementation_->solve(values, right_side);
}

long LinearSolver::factorisations() const {
  return implementation_->factorisations();
}

}  // namespace fissura::network
