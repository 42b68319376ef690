// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/shut_in.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/reference/kgd_self_similar.hpp"
#include "tests/reference/pressure_steps.hpp"

namespace fissura::reference::shut_in {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

class Fracture {
 public:
  Fracture(const ScaledParameters& p, double time, int points)
      : p_(p),
        points_(pressure_steps::points(points)),
        lost_(pressure_steps::lost_openings(points_)),
        chord_(points_.gap.unaryExpr(&pressure_steps::chord)),
        angle_(points_.gap.unaryExpr(&pressure_steps::angle)),
        lost_volume_(points_.gap.unaryExpr(&pressure_steps::lost_volume)),
        volume_(p.rate * time),
        state_(points + 2) {
    const auto scales = kgd_self_similar::scales(1, p.viscosity / 12, p.rate, p.modulus, p.toughness, time);
    const auto start = kgd_self_similar::solve(1, scales.toughness, points);
    if (!start.converged) throw std::runtime_error("shut_in: the fracture at shut-in did not converge");
    for (Index i = 0; i < points; ++i) state_(i) = start.aperture[points - 1 - i] * scales.aperture;
    state_(points) = start.inlet_pressure * scales.pressure;
    state_(points + 1) = start.gamma * scales.length;
  }

  void advance(double step) {
    const VectorXd volume_before = volume_beyond(state_);
    const double length_before = state_(count() + 1);
    for (int iteration = 0; iteration < 50; ++iteration) {
      VectorXd residual, shifted;
      MatrixXd jacobian;
      assemble(volume_before, length_before, step, state_, residual, &jacobian);
      VectorXd longer = state_;
      longer(count() + 1) *= 1 + 1e-7;
      assemble(volume_before, length_before, step, longer, shifted, nullptr);
      jacobian.col(count() + 1) = (shifted - residual) / (1e-7 * state_(count() + 1));
      const VectorXd change = jacobian.partialPivLu().solve(residual);
      const double largest = (change.array() / state_.array()).abs().maxCoeff();
      state_ -= std::min(1.0, 0.5 / largest) * change;
      if (largest < 1e-7) {
        assemble(volume_before, length_before, step, state_, residual, nullptr);
        return;
      }
    }
    throw std::runtime_error("shut_in: a step did not converge");
  }

  [[nodiscard]] KgdState at(double time) const {
    KgdState result;
    result.time = time;
    result.half_length = state_(count() + 1);
    result.inlet_net_pressure = state_(count());
    double lost = 0;
    for (Index i = 0; i < count(); ++i) lost += drop_(i) * pressure_steps::lost_opening(1, points_.gap(i));
    result.inlet_aperture =
        4 * result.half_length / (pi * p_.modulus) * (pi * result.inlet_net_pressure - lost);
    return result;
  }

 private:
  [[nodiscard]] Index count() const { return points_.gap.size(); }

  // Volume of one wing between each point and the tip.
  [[nodiscard]] VectorXd volume_beyond(const VectorXd& x) const {
    VectorXd result(count());
    double beyond = 0;
    for (Index i = 0; i < count(); ++i) {
      const double content = x(count() + 1) * x(i) * points_.weight(i);
      result(i) = beyond + content / 2;
      beyond += content;
    }
    return result;
  }

  // Unknowns: apertures, inlet pressure, length. Equations: elasticity, volume, toughness. The points move
  // with the tip, so that what flows past one is the growth of the volume beyond it plus what it overtakes.
  // The column of the length is left out.
  void assemble(const VectorXd& volume_before, double length_before, double step, const VectorXd& x,
                VectorXd& residual, MatrixXd* jacobian) {
    const Index n = count();
    const double pressure = x(n), length = x(n + 1);
    const VectorXd volume = volume_beyond(x);
    drop_.resize(n);
    MatrixXd by_aperture;
    if (jacobian) by_aperture.setZero(n, n);
    for (Index i = 0; i < n; ++i) {
      const double overtaken = (1 - points_.gap(i)) * (length - length_before);
      const double flow = volume(i) - volume_before(i) + overtaken * x(i);
      const double resistance = p_.viscosity * length * points_.weight(i) / (x(i) * x(i) * x(i) * step);
      drop_(i) = resistance * flow;
      if (!jacobian) continue;
      for (Index j = 0; j < i; ++j) by_aperture(i, j) = resistance * length * points_.weight(j);
      by_aperture(i, i) = resistance * (length * points_.weight(i) / 2 + overtaken) - 3 * drop_(i) / x(i);
    }
    const double scale = 4 * length / (pi * p_.modulus);
    const double volume_scale = 8 * length * length / p_.modulus;
    const double intensity_scale = 2 * std::sqrt(length / pi);
    residual.resize(n + 2);
    residual.head(n) = x.head(n) - scale * (pressure * pi * chord_ - lost_ * drop_);
    residual(n) = volume_scale * (pressure * pi / 4 - lost_volume_.dot(drop_)) - volume_;
    residual(n + 1) =
        intensity_scale * (pressure * pi / 2 - angle_.dot(drop_)) - p_.toughness / std::sqrt(32 / pi);
    if (!jacobian) return;
    jacobian->setZero(n + 2, n + 2);
    jacobian->topLeftCorner(n, n) = MatrixXd::Identity(n, n) + scale * lost_ * by_aperture;
    jacobian->col(n).head(n) = -scale * pi * chord_;
    jacobian->row(n).head(n) = -volume_scale * lost_volume_.transpose() * by_aperture;
    (*jacobian)(n, n) = volume_scale * pi / 4;
    jacobian->row(n + 1).head(n) = -intensity_scale * angle_.transpose() * by_aperture;
    (*jacobian)(n + 1, n) = intensity_scale * pi / 2;
  }

  ScaledParameters p_;
  pressure_steps::Points points_;
  MatrixXd lost_;
  VectorXd chord_, angle_, lost_volume_;
  double volume_;
  VectorXd state_;
  VectorXd drop_;  ///< of pressure at each point, of the last assembly
};

}  // namespace

std::vector<KgdState> solve(const ScaledParameters& p, double shut_in_time, const std::vector<double>& times,
                            const Resolution& resolution) {
  Fracture fracture(p, shut_in_time, resolution.points);
  std::vector<KgdState> result;
  double age = 0;
  for (const double time : times) {
    while (shut_in_time + age < time * (1 - 1e-12)) {
      const double step = std::min(time - shut_in_time - age, std::max(1e-3, resolution.step_fraction * age));
      fracture.advance(step);
      age += step;
    }
    result.push_back(fracture.at(time));
  }
  return result;
}

}  // namespace fissura::reference::shut_in
