// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "common/case/case_json.hpp"
#include "common/coupling/interface_compliance.hpp"
#include "coupler/scheme/coupling_law.hpp"
#include "coupler/scheme/interval_figures.hpp"
#include "tests/coupler/scheme/chain.hpp"
#include "tests/reference/displacement_discontinuity.hpp"
#include "tests/network/messaged_network.hpp"

/// The staggered scheme with the coupler's own laws, ramps and messages and the real flow solver around a
/// rock without inertia. Inertia only makes the rock stiffer within an interval, so that this is the hardest
/// rock for the scheme.

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr std::size_t count = 21;
constexpr double spacing = 0.5, modulus = 33.3333e9, closure = 5e6, bulk_modulus = 2e9,
                 pressure_at_rest = 6e6;
constexpr int pumped_intervals = 100;

/// Openings of a straight crack under given pressures on its faces: e = C (p - closure), C = A^-1 of the
/// displacement-discontinuity method.
class ElasticCrack {
 public:
  ElasticCrack() {
    std::vector<double> edges;
    for (std::size_t i = 0; i <= count; ++i) edges.push_back(spacing * static_cast<double>(i));
    compliance_ = reference::displacement_discontinuity::stiffness(edges, modulus).inverse();
  }

  [[nodiscard]] std::vector<double> opening(const std::vector<double>& pressure) const {
    Eigen::VectorXd net(static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i) net[static_cast<Eigen::Index>(i)] = pressure[i] - closure;
    const Eigen::VectorXd opening = compliance_ * net;
    return {opening.begin(), opening.end()};
  }

  /// Equilibrium with the ramps at the end of their interval: the openings for which opening(applied) =
  /// opening, by Newton's method.
  [[nodiscard]] StructureResponse follow(const std::vector<PressureRamp>& ramps,
                                         StructureResponse state) const {
    constexpr double probe = 1e-9;
    for (int iteration = 0; iteration < 4; ++iteration) {
      Eigen::MatrixXd jacobian = Eigen::MatrixXd::Identity(compliance_.rows(), compliance_.cols());
      for (std::size_t i = 0; i < count; ++i) {
        state.pressure_applied[i] = ramps[i].applied(1, state.aperture[i]);
        const double slope =
            (ramps[i].applied(1, state.aperture[i] + probe) - state.pressure_applied[i]) / probe;
        jacobian.col(static_cast<Eigen::Index>(i)) -= slope * compliance_.col(static_cast<Eigen::Index>(i));
      }
      const std::vector<double> target = opening(state.pressure_applied);
      Eigen::VectorXd residual(compliance_.rows());
      for (std::size_t i = 0; i < count; ++i)
        residual[static_cast<Eigen::Index>(i)] = target[i] - state.aperture[i];
      const Eigen::VectorXd correction = jacobian.partialPivLu().solve(residual);
      for (std::size_t i = 0; i < count; ++i) state.aperture[i] += correction[static_cast<Eigen::Index>(i)];
    }
    for (std::size_t i = 0; i < count; ++i)
      state.pressure_applied[i] = ramps[i].applied(1, state.aperture[i]);
    return state;
  }

 private:
  Eigen::MatrixXd compliance_;
};

/// Pumping for the first intervals, `volume` [m2] in each of `duration` [s], then rest.
Case pumped_case(double volume, double duration) {
  Case value;
  value.time.end = 1e6;
  value.domain = {1000, 1000, 1};
  value.fluids = {{"water", 1.67e-3, 1, bulk_modulus}};
  value.injection.well_index = 1e-5;
  value.injection.perforations = {{"perforation", {0, 0}, 1e-5}};
  value.injection.stages = {{.begin = 0, .rate = volume / duration, .fluid = "water"},
                            {.begin = pumped_intervals * duration, .rate = 0, .fluid = "water"}};
  return value;
}

enum class FluidStiffness { as_built, doubled };

/// Crack and fluid, coupled interval by interval.
class CoupledCrack {
 public:
  /// @param pumped_volume  in each of the first intervals [m2]
  CoupledCrack(double compliance_factor, double duration, FluidStiffness stiffness, double pumped_volume)
      : duration_(duration), stiffness_(stiffness) {
    network_.apply(test::chain(count, spacing, 0));
    compliance_ = interface_compliance(network_, modulus, compliance_factor);
    flow_.join({case_to_json(pumped_case(pumped_volume, duration)), 1});
    (void)flow_.insert(test::chain(count, spacing, 0));
    structure_.pressure_applied.assign(count, pressure_at_rest);
    structure_.pressure_opening.assign(count, 0);
    structure_.aperture = crack_.opening(structure_.pressure_applied);
    structure_.closed.assign(count, 0);
    structure_.broken.assign(count, 1);
  }

  /// Presses on every other node with `amplitude` [Pa] more and on the others with as much less: the shortest
  /// wave of the mesh.
  void disturb(double amplitude) {
    for (std::size_t i = 0; i < count; ++i)
      structure_.pressure_applied[i] += i % 2 == 0 ? amplitude : -amplitude;
    structure_.aperture = crack_.opening(structure_.pressure_applied);
  }

  void advance() {
    const ClockInterval interval{++index_, time_, time_ + duration_};
    const Message answer =
        flow_.advance(advance_network(interval, 0, robin_estimate(structure_, compliance_)));
    answer_ = read_pressure(answer, network_, {0, 1e12});
    std::vector<PressureRamp> ramps = robin_ramps(structure_, answer_, compliance_, bulk_modulus);
    if (stiffness_ == FluidStiffness::doubled)
      for (PressureRamp& ramp : ramps) ramp.stiffness *= 2;
    structure_ = crack_.follow(ramps, structure_);
    time_ = interval.end;
  }

  /// Largest difference of the applied pressures from their mean [Pa].
  [[nodiscard]] double unevenness() const {
    double mean = 0, largest = 0;
    for (const double pressure : structure_.pressure_applied) mean += pressure / static_cast<double>(count);
    for (const double pressure : structure_.pressure_applied)
      largest = std::max(largest, std::abs(pressure - mean));
    return largest;
  }

  /// Fluid that the structure's openings hold at the pressures of the network, as volume at zero pressure
  /// [m2].
  [[nodiscard]] double content() const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      sum += spacing * structure_.aperture[i] * (1 + answer_.pressure[i] / bulk_modulus);
    return sum;
  }

  [[nodiscard]] double volume_error() const { return drift(network_, structure_, answer_); }
  [[nodiscard]] const NetworkAnswer& answer() const { return answer_; }

 private:
  double duration_;
  FluidStiffness stiffness_;
  ElasticCrack crack_;
  FractureNetwork network_;
  network::test::MessagedNetwork flow_;
  std::vector<double> compliance_;
  StructureResponse structure_;
  NetworkAnswer answer_;
  std::uint64_t index_ = 0;
  double time_ = 0;
};

}  // namespace

TEST_CASE("no disturbance of the interface grows, whatever the compliance factor and the interval",
          "[coupler][scheme]") {
  const double factor = GENERATE(0.05, 0.3, 1.0, 3.0, 10.0), duration = GENERATE(1e-3, 1e-2, 1e-1, 1.0);
  CAPTURE(factor, duration);
  CoupledCrack crack(factor, duration, FluidStiffness::as_built, 0);
  for (int k = 0; k < 100; ++k) crack.advance();
  crack.disturb(1e2);
  const double start = crack.unevenness();
  for (int k = 0; k < 300; ++k) {
    crack.advance();
    REQUIRE(crack.unevenness() < start);
  }
  // The slowest decay is that of a fluid that hardly moves within an interval.
  CHECK(crack.unevenness() < 0.1 * start);
  CHECK(crack.volume_error() < 1e-6);
}

TEST_CASE("with k_s above 1/C_R a fluid that moves freely makes the interface unstable",
          "[coupler][scheme]") {
  // Short waves open the rock far less than C_R says: twice 1/C_R answers a disturbance with up to twice its
  // opposite.
  const double factor = GENERATE(0.3, 1.0, 3.0), duration = GENERATE(1e-1, 1.0);
  CAPTURE(factor, duration);
  CoupledCrack crack(factor, duration, FluidStiffness::doubled, 0);
  crack.disturb(1e2);
  const double start = crack.unevenness();
  for (int k = 0; k < 300; ++k) crack.advance();
  CHECK(crack.unevenness() > 10 * start);
}

TEST_CASE("all that was pumped is in the structure soon after the pumping has stopped", "[coupler][scheme]") {
  const double factor = GENERATE(0.05, 0.3, 1.0, 3.0, 10.0), duration = GENERATE(1e-2, 1e-1);
  CAPTURE(factor, duration);
  CoupledCrack crack(factor, duration, FluidStiffness::as_built, 1e-5);
  for (int k = 0; k < pumped_intervals; ++k) crack.advance();
  // While it is pumped the structure lags behind the content by a part of what one interval brings.
  CHECK(crack.volume_error() < 1e-2);
  for (int k = 0; k < 300; ++k) crack.advance();
  CHECK(crack.volume_error() < 1e-6);
  const Ledger& ledger = crack.answer().ledger;
  CHECK(ledger.injected == Approx(pumped_intervals * 1e-5).epsilon(1e-12));
  CHECK(crack.content() == Approx(ledger.in_place + ledger.injected).epsilon(1e-6));
}
