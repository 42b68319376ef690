// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/fixed_crack.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "tests/reference/displacement_discontinuity.hpp"

namespace fissura::reference::fixed_crack {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Crack {
 public:
  Crack(const Parameters& parameters, int cells)
      : p_(parameters), cell_(2 * parameters.half_length / cells), middle_(cells / 2) {
    std::vector<double> edges;
    for (int i = 0; i <= cells; ++i) edges.push_back(-p_.half_length + i * cell_);
    compliance_ = displacement_discontinuity::stiffness(edges, p_.plane_strain_modulus).inverse();
    pressure_ = VectorXd::Constant(cells, p_.initial_pressure);
  }

  void advance(double step) {
    const VectorXd before = content(pressure_);
    for (int iteration = 0; iteration < 30; ++iteration) {
      VectorXd residual;
      MatrixXd jacobian;
      assemble(before, step, residual, jacobian);
      const VectorXd change = jacobian.partialPivLu().solve(residual);
      pressure_ -= change;
      if (change.cwiseAbs().maxCoeff() < 1e-9 * pressure_.cwiseAbs().maxCoeff()) return;
    }
    throw std::runtime_error("fixed_crack: a step did not converge");
  }

  [[nodiscard]] double inlet_aperture() const { return compliance_.row(middle_).dot(pressure_); }
  [[nodiscard]] double inlet_pressure() const { return pressure_(middle_); }

 private:
  [[nodiscard]] VectorXd content(const VectorXd& pressure) const {
    return (compliance_ * pressure)
        .cwiseProduct(VectorXd::Ones(pressure.size()) + pressure / p_.bulk_modulus);
  }

  void assemble(const VectorXd& before, double step, VectorXd& residual, MatrixXd& jacobian) const {
    const Index count = pressure_.size();
    const VectorXd aperture = compliance_ * pressure_;
    const VectorXd compression = VectorXd::Ones(count) + pressure_ / p_.bulk_modulus;
    residual = cell_ * (content(pressure_) - before);
    jacobian = cell_ * compression.asDiagonal() * compliance_;
    jacobian.diagonal() += cell_ / p_.bulk_modulus * aperture;
    residual(middle_) -= step * p_.rate;
    for (Index i = 0; i + 1 < count; ++i) {
      const double mean = (aperture(i) + aperture(i + 1)) / 2;
      const double conductance = std::pow(mean, 3) / (12 * p_.viscosity * cell_);
      const double difference = pressure_(i) - pressure_(i + 1);
      const double flow = step * conductance * difference;
      residual(i) += flow;
      residual(i + 1) -= flow;
      const VectorXd by_aperture =
          (1.5 * flow / mean) * (compliance_.row(i) + compliance_.row(i + 1)).transpose();
      jacobian.row(i) += by_aperture.transpose();
      jacobian.row(i + 1) -= by_aperture.transpose();
      jacobian(i, i) += step * conductance;
      jacobian(i, i + 1) -= step * conductance;
      jacobian(i + 1, i) -= step * conductance;
      jacobian(i + 1, i + 1) += step * conductance;
    }
  }

  Parameters p_;
  double cell_;
  Index middle_;
  MatrixXd compliance_;
  VectorXd pressure_;
};

}  // namespace

std::vector<Inlet> solve(const Parameters& parameters, int cells, double step,
                         const std::vector<double>& times) {
  Crack crack(parameters, cells);
  std::vector<Inlet> result;
  long done = 0;
  for (const double time : times) {
    for (const long target = std::lround(time / step); done < target; ++done) crack.advance(step);
    result.push_back({time, crack.inlet_aperture(), crack.inlet_pressure()});
  }
  return result;
}

std::vector<Inlet> extrapolate(const Parameters& parameters, int cells, double step,
                               const std::vector<double>& times) {
  const int finer = 2 * cells + 1;
  const auto coarse = solve(parameters, cells, step, times);
  const auto fine = solve(parameters, finer, step, times);
  const auto short_step = solve(parameters, cells, step / 2, times);
  // value(l) = limit + c l with the cell lengths l ~ 1/cells and 1/finer.
  const double by_cells = double(cells) / (finer - cells);
  auto result = fine;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i].aperture += by_cells * (fine[i].aperture - coarse[i].aperture) +
                          2 * (short_step[i].aperture - coarse[i].aperture);
    result[i].pressure += by_cells * (fine[i].pressure - coarse[i].pressure) +
                          2 * (short_step[i].pressure - coarse[i].pressure);
  }
  return result;
}

Parameters case_parameters() {
  return {20, 32e9 / (1 - 0.2 * 0.2), 1.67e-3, 2e9, 1e-3, 0.2e6};
}

std::vector<double> case_times() {
  return {1, 2, 5, 10, 20};
}

}  // namespace fissura::reference::fixed_crack
