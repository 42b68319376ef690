// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/explicit/explicit_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "common/errors.hpp"
#include "common/exchange/participant.hpp"
#include "network/laws/cubic_law.hpp"
#include "network/laws/power_law_fluid.hpp"

namespace fissura::explicit_flow {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Of a piece, so that the answer is not that of one long step where the bound allows it.
constexpr int least_sub_steps = 8;
constexpr int maximum_sweeps = 100;
/// Change of pressure at which sweeps end, as a share of the greatest pressure.
constexpr double sweep_tolerance = 1e-12;
constexpr int sub_steps_between_signs = 64;

}  // namespace

std::set<std::string> ExplicitSolver::physics() const {
  return {claims::viscous_flow, claims::leak_off, claims::power_law, claims::pressure_control,
          claims::carry_pressure};
}

nlohmann::json ExplicitSolver::finish() const {
  return {{"sub_steps", sub_steps_}};
}

void ExplicitSolver::prepare() {
  std::vector<std::vector<Arm>> arms(length_.size());
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    arms[ends_[s].a].push_back({s, ends_[s].b});
    arms[ends_[s].b].push_back({s, ends_[s].a});
  }
  arms_.clear();
  arm_begin_.assign(1, 0);
  for (const auto& of_cell : arms) {
    arms_.insert(arms_.end(), of_cell.begin(), of_cell.end());
    arm_begin_.push_back(arms_.size());
  }
  for (auto* per_cell : {&due_, &asked_, &inflow_, &slope_, &threshold_, &bound_})
    per_cell->resize(arms.size());
  for (auto* per_segment : {&aperture_, &conductance_, &flux_}) per_segment->resize(ends_.size());
  for (auto* per_perforation : {&gain_, &there_}) per_perforation->resize(perforations_.size());
  is_stiff_.resize(arms.size());
  order_.resize(arms.size());
}

int ExplicitSolver::cover(double end) {
  const double begin = state_.time;
  const bool moving = std::ranges::any_of(interval_->aperture_rate, [](double rate) { return rate != 0; });
  const bool newtonian = case_.fluids.front().power_index == 1;
  begin_piece(end);
  const double longest = (end - begin) / least_sub_steps;
  double bound = stable_step();
  long steps = 0;
  while (state_.time < end) {
    if (steps > 0 && !newtonian) set_conductance();
    if (steps > 0 && (moving || !newtonian)) bound = stable_step();
    const double left = end - state_.time;
    const double count = std::max(1.0, std::ceil(left / std::min(bound, longest)));
    double next = state_.time + left / count;
    if (count <= 1 || next <= state_.time) next = end;
    if (moving) set_laws(next);
    sub_step(next, (next - begin) / (end - begin));
    if (++steps % sub_steps_between_signs == 0) note_progress("sub-steps");
    if (steps > maximum_sub_steps)
      throw SolverError(fmt::format("the interval to {} s takes more than {} sub-steps, the last of {} s",
                                    end, maximum_sub_steps, left / count));
  }
  sub_steps_ += steps;
  end_piece(begin, end);
  return static_cast<int>(std::min<long>(steps, std::numeric_limits<int>::max()));
}

void ExplicitSolver::begin_piece(double end) {
  const std::size_t cells = length_.size();
  content_at_begin_ = state_.content;
  moved_.assign(ends_.size(), 0.0);
  piece_ = {.end = end,
            .taken = std::vector<double>(cells, 0.0),
            .brought = std::vector<double>(perforations_.size(), 0.0),
            .last_rate = std::vector<double>(perforations_.size(), 0.0)};
  for (std::size_t i = 0; i < cells; ++i) due_[i] = leak_off_demand(i, end);
  for (std::size_t i = 0; i < cells; ++i) {
    const double opening = opening_pressure(laws_[i]);
    if (std::isfinite(opening) && (opening == 0 || state_.content[i] > cell_content(laws_[i], opening)))
      state_.pressure[i] = cell_pressure(laws_[i], state_.content[i]);
  }
  set_segment_apertures();
  set_conductance();
}

/// Contents once more from what moved in all: sub-steps round, this does not add up.
void ExplicitSolver::end_piece(double begin, double end) {
  std::vector<double> gained(length_.size(), 0.0);
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    gained[ends_[s].a] -= moved_[s];
    gained[ends_[s].b] += moved_[s];
    state_.flux[s] = moved_[s] / (end - begin);
  }
  for (std::size_t k = 0; k < perforations_.size(); ++k) gained[perforations_[k]] += piece_.brought[k];
  for (std::size_t i = 0; i < length_.size(); ++i)
    state_.content[i] = std::max(0.0, content_at_begin_[i] + gained[i] / length_[i] - piece_.taken[i]);
  keep_piece(piece_);
}

void ExplicitSolver::set_segment_apertures() {
  const bool per_arm = !interval_->arm_aperture_a.empty();
  for (std::size_t s = 0; s < ends_.size(); ++s)
    aperture_[s] = network::segment_aperture(
        per_arm ? interval_->arm_aperture_a[s] : interval_->aperture[ends_[s].a],
        per_arm ? interval_->arm_aperture_b[s] : interval_->aperture[ends_[s].b], case_.minimum_aperture);
}

void ExplicitSolver::set_conductance() {
  const FlowFluid& fluid = case_.fluids.front();
  const network::PowerLaw law{fluid.consistency_index, fluid.power_index};
  conductance_sum_.assign(length_.size(), 0.0);
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    const auto [a, b] = ends_[s];
    const double gradient = (state_.pressure[a] - state_.pressure[b]) / segment_length_[s];
    const double viscosity =
        network::viscosity_from_gradient(law, aperture_[s], std::hypot(gradient, network::gradient_floor));
    conductance_[s] = network::transmissibility(aperture_[s], viscosity, segment_length_[s]);
    conductance_sum_[a] += conductance_[s];
    conductance_sum_[b] += conductance_[s];
  }
}

double ExplicitSolver::stable_step() {
  const std::size_t cells = length_.size();
  bound_.assign(cells, infinite);
  const double thinning = std::min(1.0, case_.fluids.front().power_index);
  for (std::size_t i = 0; i < cells; ++i) {
    const cells::CellLaw& law = laws_[i];
    const double opening = opening_pressure(law);
    const bool opens = std::isfinite(opening);
    slope_[i] = !opens ? 0
                       : law.compliance * (1 + opening / law.bulk_modulus) +
                             cell_aperture(law, opening) / law.bulk_modulus;
    threshold_[i] = !opens ? infinite : opening > 0 ? cell_content(law, opening) : -infinite;
    if (conductance_sum_[i] > 0) bound_[i] = thinning * length_[i] * slope_[i] / conductance_sum_[i];
  }
  std::vector<double> sorted = bound_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(cells / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  double least = infinite;
  for (std::size_t i = 0; i < cells; ++i) {
    if (std::isfinite(*middle) && bound_[i] < stiff_share * *middle) threshold_[i] = infinite;
    if (threshold_[i] != infinite) least = std::min(least, bound_[i]);
  }
  return stable_share * least;
}

void ExplicitSolver::sub_step(double end, double progress) {
  const double dt = end - state_.time;
  for (std::size_t i = 0; i < length_.size(); ++i) asked_[i] = progress * due_[i] - piece_.taken[i];
  set_flux();
  std::fill(piece_.last_rate.begin(), piece_.last_rate.end(), 0.0);
  gather();
  feed(well_demand(state_.time, end), dt);
  gather();
  find_stiff(dt);
  if (!stiff_.empty()) balance_stiff(dt);
  limit_outflow(dt);
  for (std::size_t s = 0; s < ends_.size(); ++s) moved_[s] += dt * flux_[s];
  for (std::size_t k = 0; k < perforations_.size(); ++k) piece_.brought[k] += dt * piece_.last_rate[k];
  for (std::size_t i = 0; i < length_.size(); ++i) {
    const double total = std::max(0.0, state_.content[i] + dt * inflow_[i] / length_[i]);
    const double taken = std::min(asked_[i], total);
    piece_.taken[i] += taken;
    state_.content[i] = total - taken;
    if (!is_stiff_[i]) state_.pressure[i] = cell_pressure(laws_[i], state_.content[i]);
  }
  state_.time = end;
}

void ExplicitSolver::set_flux() {
  for (std::size_t s = 0; s < ends_.size(); ++s)
    flux_[s] = conductance_[s] * (state_.pressure[ends_[s].a] - state_.pressure[ends_[s].b]);
}

void ExplicitSolver::gather() {
  std::fill(inflow_.begin(), inflow_.end(), 0.0);
  for (std::size_t s = 0; s < ends_.size(); ++s) {
    inflow_[ends_[s].a] -= flux_[s];
    inflow_[ends_[s].b] += flux_[s];
  }
  for (std::size_t k = 0; k < perforations_.size(); ++k) inflow_[perforations_[k]] += piece_.last_rate[k];
}

void ExplicitSolver::feed(const cells::WellDemand& well, double dt) {
  const std::size_t count = perforations_.size();
  if (count == 0) return;
  std::vector<double>& rate = piece_.last_rate;
  double gain_sum = 0, weighted = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = perforations_[k];
    const double storage = length_[i] * slope_[i], outlet = conductance_sum_[i];
    const double resistance = storage > 0 ? dt / storage : outlet > 0 ? 1 / outlet : 0;
    gain_[k] = case_.well_index / (1 + case_.well_index * resistance);
    there_[k] = state_.pressure[i] + inflow_[i] * resistance;
    gain_sum += gain_[k];
    weighted += gain_[k] * there_[k];
  }
  const bool given = well.control == WellControl::pressure;
  const double pressure = given ? well.target : (well.target + weighted) / gain_sum;
  for (std::size_t k = 0; k < count; ++k) rate[k] = gain_[k] * (pressure - there_[k]);
  const double missing = given ? 0 : well.target - std::accumulate(rate.begin(), rate.end(), 0.0);
  for (double& each : rate) each += missing / static_cast<double>(count);
}

void ExplicitSolver::find_stiff(double dt) {
  stiff_.clear();
  for (std::size_t i = 0; i < length_.size(); ++i) {
    const double content = state_.content[i];
    const double after = content + dt * inflow_[i] / length_[i] - asked_[i];
    is_stiff_[i] = std::min(content, after) <= threshold_[i] && conductance_sum_[i] > 0;
    if (is_stiff_[i]) stiff_.push_back(i);
  }
}

void ExplicitSolver::balance_stiff(double dt) {
  std::vector<double>& pressure = state_.pressure;
  for (int sweep = 0; sweep < maximum_sweeps; ++sweep) {
    double change = 0, greatest = 0;
    for (const std::size_t i : stiff_) {
      double supply = 0;
      for (std::size_t k = 0; k < perforations_.size(); ++k)
        if (perforations_[k] == i) supply += piece_.last_rate[k];
      for (std::size_t k = arm_begin_[i]; k < arm_begin_[i + 1]; ++k)
        supply += conductance_[arms_[k].segment] * pressure[arms_[k].cell];
      const double balanced =
          balanced_pressure(laws_[i], length_[i], state_.content[i], dt * conductance_sum_[i],
                            dt * supply - length_[i] * asked_[i]);
      change = std::max(change, std::abs(balanced - pressure[i]));
      greatest = std::max(greatest, balanced);
      pressure[i] = balanced;
    }
    if (change <= sweep_tolerance * greatest) break;
    std::reverse(stiff_.begin(), stiff_.end());
  }
  set_flux();
  gather();
}

void ExplicitSolver::limit_outflow(double dt) {
  const auto short_of_fluid = [&](std::size_t i) {
    return state_.content[i] + dt * inflow_[i] / length_[i] < 0;
  };
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (std::ranges::none_of(order_, short_of_fluid)) return;
  std::ranges::stable_sort(order_, std::greater{}, [&](std::size_t i) { return state_.pressure[i]; });
  for (const std::size_t i : order_) {
    double in = 0, out = 0;
    const auto count = [&](double rate) { (rate > 0 ? in : out) += std::abs(rate); };
    for (std::size_t k = arm_begin_[i]; k < arm_begin_[i + 1]; ++k)
      count(ends_[arms_[k].segment].b == i ? flux_[arms_[k].segment] : -flux_[arms_[k].segment]);
    for (std::size_t k = 0; k < perforations_.size(); ++k)
      if (perforations_[k] == i) count(piece_.last_rate[k]);
    const double there = length_[i] * state_.content[i] + dt * in;
    if (dt * out <= there) continue;
    const double factor = there / (dt * out);
    for (std::size_t k = arm_begin_[i]; k < arm_begin_[i + 1]; ++k) {
      double& flux = flux_[arms_[k].segment];
      if ((ends_[arms_[k].segment].a == i) == (flux > 0)) flux *= factor;
    }
    for (std::size_t k = 0; k < perforations_.size(); ++k)
      if (perforations_[k] == i && piece_.last_rate[k] < 0) piece_.last_rate[k] *= factor;
  }
  gather();
}

}  // namespace fissura::explicit_flow
