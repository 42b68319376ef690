// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "network/cells/cell_solver.hpp"

namespace fissura::uniform_flow {

/// How the pressure of a volume was found.
struct PressureReport {
  double pressure = 0;  ///< [Pa]
  bool converged = false;
  int iterations = 0;
  double residual = 0;  ///< relative to the volume
};

/// The limit of a fluid without viscosity: what is connected by segments has one pressure p >= 0, that of its
/// volume,
///   V = sum_i l_i m_i(p);      V(end) = V(begin) + dt sum q - sum l_i taken_i,      q = WI (p_w - p)
/// Where it does not fill its cells, V < sum_i l_i e_i(0), all are filled to the same share. Between parts
/// that are not connected fluid goes through the well only. Reports no flux: without viscosity no pressure
/// drop tells one.
class UniformSolver : public cells::CellSolver {
 public:
  [[nodiscard]] std::set<std::string> physics() const override;

 protected:
  void prepare() override;
  int cover(double end) override;

 private:
  struct Part {
    std::vector<std::size_t> cells;
    std::vector<std::size_t> perforations;
    double volume = 0;  ///< [m2]
    double rate = 0;    ///< of its perforations [m2/s]
  };

  /// sum_i l_i m_i(p) of a part [m2].
  [[nodiscard]] double room(const Part& part, double pressure) const;
  /// The p >= 0 with  room(p) + conductance p = supply;  0 if room(0) is not filled. Newton's method,
  /// bisecting where that leaves the bracket; both sides rise with p. @param conductance  [m2/Pa]
  /// @param supply  [m2]
  [[nodiscard]] PressureReport pressure_of(const Part& part, double conductance, double supply) const;
  void share_rate(const cells::WellDemand& well, double dt);
  /// Rates of the parts under a well pressure [m2/s], and their sum.
  double feed(double well_pressure, double dt);
  void fill(const Part& part);

  std::vector<Part> parts_;
  int iterations_ = 0;
};

}  // namespace fissura::uniform_flow
