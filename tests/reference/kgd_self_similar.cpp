// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/kgd_self_similar.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/reference/pressure_steps.hpp"

namespace fissura::reference::kgd_self_similar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

using pressure_steps::angle;
using pressure_steps::chord;
using pressure_steps::lost_opening;
using pressure_steps::lost_volume;

class Problem {
 public:
  Problem(double power_index, double toughness, int points)
      : Problem(power_index, toughness, pressure_steps::points(points)) {}

  [[nodiscard]] Index points() const { return gap_.size(); }

  /// Apertures, then the inlet pressure, then gamma.
  [[nodiscard]] VectorXd first_guess() const {
    VectorXd x(points() + 2);
    const double gamma = std::min(0.6, toughness_ > 0 ? 0.9324 * std::pow(toughness_, -2.0 / 3) : 1.0);
    for (Index i = 0; i < points(); ++i) {
      const double by_toughness = toughness_ * std::sqrt(gamma * gap_(i));
      const double by_viscosity = 3 * gamma * std::pow(gap_(i), 2 / (n_ + 2));
      x(i) = std::pow(std::pow(by_toughness, n_ + 2) + std::pow(by_viscosity, n_ + 2), 1 / (n_ + 2));
    }
    x.head(points()) /= 2 * gamma * x.head(points()).dot(weight_);
    x(points()) = x(points() - 1) / (4 * gamma);
    x(points() + 1) = gamma;
    return x;
  }

  /// One Newton step; returns the largest relative change.
  double improve(VectorXd& x) const {
    const Index count = points();
    const double pressure = x(count), gamma = x(count + 1);
    VectorXd drop(count);
    MatrixXd by_aperture = MatrixXd::Zero(count, count);
    double beyond = 0;
    for (Index i = 0; i < count; ++i) {
      const double content = x(i) * weight_(i);
      const double flux = gamma * (beyond + content / 2 + alpha_ * (1 - gap_(i)) * x(i));
      beyond += content;
      drop(i) = gamma * std::pow(flux, n_) * std::pow(x(i), -2 * n_ - 1) * weight_(i);
      const double factor = drop(i) * n_ * gamma / flux;
      for (Index j = 0; j < i; ++j) by_aperture(i, j) = factor * weight_(j);
      by_aperture(i, i) = factor * (weight_(i) / 2 + alpha_ * (1 - gap_(i))) - drop(i) * (2 * n_ + 1) / x(i);
    }
    const VectorXd by_gamma = (1 + n_) / gamma * drop;
    const VectorXd c = gap_.unaryExpr(&chord), acos_xi = gap_.unaryExpr(&angle),
                   volume_lost = gap_.unaryExpr(&lost_volume);

    VectorXd residual(count + 2);
    MatrixXd jacobian = MatrixXd::Zero(count + 2, count + 2);
    const double scale = 4 * gamma / pi;
    const VectorXd opening = pressure * pi * c - lost_ * drop;
    residual.head(count) = x.head(count) - scale * opening;
    jacobian.topLeftCorner(count, count) = MatrixXd::Identity(count, count) + scale * lost_ * by_aperture;
    jacobian.col(count).head(count) = -scale * pi * c;
    jacobian.col(count + 1).head(count) = -opening * 4 / pi + scale * lost_ * by_gamma;

    const double volume = pressure * pi / 4 - volume_lost.dot(drop);
    residual(count) = 8 * gamma * gamma * volume - 1;
    jacobian.row(count).head(count) = -8 * gamma * gamma * volume_lost.transpose() * by_aperture;
    jacobian(count, count) = 2 * pi * gamma * gamma;
    jacobian(count, count + 1) = 16 * gamma * volume - 8 * gamma * gamma * volume_lost.dot(by_gamma);

    const double intensity = pressure * pi / 2 - acos_xi.dot(drop);
    const double factor = 8 * std::numbers::sqrt2 / pi * std::sqrt(gamma);
    residual(count + 1) = factor * intensity - toughness_;
    jacobian.row(count + 1).head(count) = -factor * acos_xi.transpose() * by_aperture;
    jacobian(count + 1, count) = factor * pi / 2;
    jacobian(count + 1, count + 1) = factor * (intensity / (2 * gamma) - acos_xi.dot(by_gamma));

    const VectorXd change = jacobian.partialPivLu().solve(residual);
    const double largest = (change.array() / x.array()).abs().maxCoeff();
    x -= std::min(1.0, 0.5 / largest) * change;
    return largest;
  }

  void fill(const VectorXd& x, Solution& solution) const {
    const Index count = points();
    const double gamma = x(count + 1);
    solution.gamma = gamma;
    solution.inlet_pressure = x(count);
    // The opening at the middle, xi = 0, of the same pressure.
    double lost = 0, beyond = 0, pressure = x(count);
    solution.xi.resize(count);
    solution.aperture.resize(count);
    solution.pressure.resize(count);
    std::vector<double> drop(count);
    for (Index i = 0; i < count; ++i) {
      const double content = x(i) * weight_(i);
      const double flux = gamma * (beyond + content / 2 + alpha_ * (1 - gap_(i)) * x(i));
      beyond += content;
      drop[i] = gamma * std::pow(flux, n_) * std::pow(x(i), -2 * n_ - 1) * weight_(i);
      lost += drop[i] * lost_opening(1, gap_(i));
    }
    solution.inlet_aperture = 4 * gamma / pi * (x(count) * pi - lost);
    for (Index i = 0; i < count; ++i) {
      const Index from_inlet = count - 1 - i;
      pressure -= drop[from_inlet] / 2;
      solution.xi[i] = 1 - gap_(from_inlet);
      solution.aperture[i] = x(from_inlet);
      solution.pressure[i] = pressure;
      pressure -= drop[from_inlet] / 2;
    }
  }

 private:
  Problem(double power_index, double toughness, const pressure_steps::Points& points)
      : n_(power_index),
        toughness_(toughness),
        alpha_((n_ + 1) / (n_ + 2)),
        gap_(points.gap),
        weight_(points.weight),
        lost_(pressure_steps::lost_openings(points)) {}

  double n_, toughness_, alpha_;
  VectorXd gap_, weight_;
  MatrixXd lost_;
};

}  // namespace

Solution solve(double power_index, double toughness, int points) {
  const Problem problem(power_index, toughness, points);
  VectorXd x = problem.first_guess();
  Solution solution;
  while (solution.iterations < 100 && !solution.converged) {
    ++solution.iterations;
    solution.residual = problem.improve(x);
    solution.converged = solution.residual < 1e-8;
  }
  problem.fill(x, solution);
  return solution;
}

Scales scales(double power_index, double consistency_index, double rate, double plane_strain_modulus,
              double scaled_toughness, double time) {
  const double n = power_index;
  const double m = std::pow(2, n + 1) * std::pow((2 * n + 1) / n, n) * consistency_index;
  const double epsilon = std::pow(m / (plane_strain_modulus * std::pow(time, n)), 1 / (n + 2));
  Scales result;
  result.length = std::sqrt(rate * time / epsilon);
  result.aperture = epsilon * result.length;
  result.pressure = plane_strain_modulus * epsilon;
  result.toughness = scaled_toughness / (plane_strain_modulus * epsilon * std::sqrt(result.length));
  return result;
}

}  // namespace fissura::reference::kgd_self_similar
