// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

/// How far events reach in time. Laws.
namespace fissura::coupler {

/// r = sqrt(4 pi D t) (Shapiro, Huenges & Borm 1997)  [m]. @pre diffusivity [m2/s] and time [s] >= 0
double triggering_front(double diffusivity, double time);

/// r = sqrt(2 d D t (t / t_0 - 1) ln(t / (t - t_0))) (Parotidis, Shapiro & Rothert 2004)  [m]: behind it
/// events cease when pumping ended at t_0. d: dimension of the space in which pressure spreads; t [s] counts
/// from the start of pumping. 0 at t_0. @pre time >= shut_in > 0
double back_front(double diffusivity, double time, double shut_in, int dimension);

/// Distance = coefficient * time^exponent.
struct PowerLaw {
  double coefficient = 0;                ///< [m/s^exponent]
  double exponent = 0;                   ///< [-]
  std::optional<double> exponent_sigma;  ///< standard error; none from two points [-]
};

/// Least squares of ln(distance) over ln(time). None from fewer than two different times.
/// @pre as many times [s] as distances [m], all > 0
std::optional<PowerLaw> fitted_power_law(std::span<const double> times, std::span<const double> distances);

/// Coefficient of a power law of given exponent, by the same least squares [m/s^exponent].
/// @pre at least one point
double fitted_coefficient(std::span<const double> times, std::span<const double> distances, double exponent);

/// Root of the mean square of ln(distance / law), about the relative deviation [-]. @pre at least one point
double misfit(std::span<const double> times, std::span<const double> distances, const PowerLaw& law);

/// D of the triggering front c sqrt(t): c^2 / (4 pi)  [m2/s].
double diffusivity_of(double coefficient);

}  // namespace fissura::coupler
