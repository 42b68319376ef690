// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

/// The b-value of the law of Gutenberg and Richter, log10 N(>= m) = a - b m, from magnitudes. Laws.
namespace fissura::coupler {

/// What the estimators need to know of the magnitudes at and above a completeness.
struct MagnitudeSample {
  std::size_t count = 0;
  double mean_excess = 0;  ///< mean of m - completeness [-]
  double square_sum = 0;   ///< sum of (m - mean)^2 [-]
};

/// Of the magnitudes m >= completeness, in any order.
MagnitudeSample magnitudes_above(std::span<const double> magnitudes, double completeness);

/// The same of magnitudes put into bins of width `bin` whose lowest edge is `completeness`, each standing for
/// the middle of its bin; excess over the middle of the lowest bin.
MagnitudeSample binned_magnitudes_above(std::span<const double> magnitudes, double completeness, double bin);

/// b = log10(e) / mean_excess, of magnitudes that are not rounded (Aki 1965). @pre mean_excess > 0
double b_value_aki(const MagnitudeSample& sample);

/// The same times (N - 1) / N: its expectation is b (Ogata & Yamashina 1986). @pre mean_excess > 0
double b_value_unbiased(const MagnitudeSample& sample);

/// b = log10(e) / (mean_excess + bin / 2), of binned magnitudes (Utsu 1965); low for great b.
double b_value_utsu(const MagnitudeSample& binned, double bin);

/// b = ln(1 + bin / mean_excess) / (bin ln 10), of binned magnitudes: the likeliest of a geometric
/// distribution (Tinti & Mulargia 1987). @pre mean_excess > 0
double b_value_geometric(const MagnitudeSample& binned, double bin);

/// Standard error b / sqrt(N) (Aki 1965). @pre count > 0
double standard_error_aki(double b, std::size_t count);

/// Standard error 2.30 b^2 sqrt(sum (m - mean)^2 / (N (N - 1))) (Shi & Bolt 1982), which also sees where
/// the law does not hold. @pre count > 1
double standard_error_shi_bolt(double b, const MagnitudeSample& sample);

}  // namespace fissura::coupler
