// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "common/seismicity/source_record.hpp"

namespace fissura::coupler {

/// Sum whose rounding error does not grow with the number of terms (Neumaier 1974).
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

/// Such a sum of each component.
class TensorSum {
 public:
  void add(const PlaneTensor& term) {
    for (std::size_t i = 0; i < term.size(); ++i) component_[i].add(term[i]);
  }
  [[nodiscard]] PlaneTensor value() const {
    return {component_[0].value(), component_[1].value(), component_[2].value(), component_[3].value()};
  }

 private:
  std::array<CompensatedSum, 4> component_;
};

}  // namespace fissura::coupler
