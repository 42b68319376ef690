// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/case/case.hpp"

namespace fissura::coupler {

/// Counts of magnitudes in bins whose middles are the multiples of `bin`, from the lowest that has one to the
/// highest, without a gap.
struct MagnitudeHistogram {
  double bin = 0;
  std::vector<double> middle;
  std::vector<std::size_t> count;
};

/// @pre bin > 0, magnitudes finite
MagnitudeHistogram magnitude_histogram(std::span<const double> magnitudes, double bin);

/// Magnitude from which a catalogue is complete, by maximum curvature: the middle of the fullest bin (of
/// equal ones the highest) plus 0.2 (Wiemer & Wyss 2000; the addition: Woessner & Wiemer 2005). None without
/// magnitudes.
std::optional<double> completeness_by_curvature(const MagnitudeHistogram& histogram);

/// Mw of the smallest thing that the mesh can break: one element of size h = mesh.tip_size whose crack opens
/// fully, over the area h x thickness,
///   M = h H w_c (lambda I + 2 mu n n),  w_c = 2 G_f / f_t,tip.
/// H is h itself with equidimensional sources. Magnitudes below show the mesh. Slip of natural fractures has
/// no such floor.
double numerical_magnitude_floor(const Case& run_case);

/// b-value of a catalogue with what is needed to judge it.
struct ReportedBValue {
  double value = 0;           ///< Aki, unbiased
  double geometric = 0;       ///< Tinti & Mulargia, of the same magnitudes in bins: a check of it
  double sigma_aki = 0;       ///< standard error
  double sigma_shi_bolt = 0;  ///< standard error
  double from = 0;            ///< least magnitude used
  std::size_t events = 0;     ///< used
};

struct FrequencyMagnitude {
  MagnitudeHistogram histogram;
  std::vector<std::size_t> cumulative;  ///< events in this bin and those above
  std::size_t events = 0;               ///< with a magnitude
  std::optional<double> completeness;
  double numerical_floor = 0;
  std::optional<ReportedBValue> b;
  std::string not_reported;  ///< why there is no b; empty if there is one
};

/// b is reported if at least 50 magnitudes reach the completeness and the numerical floor, and differ.
FrequencyMagnitude frequency_magnitude(std::span<const double> magnitudes, double numerical_floor);

}  // namespace fissura::coupler
