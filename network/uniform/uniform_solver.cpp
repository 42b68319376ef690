// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/uniform/uniform_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/errors.hpp"
#include "common/exchange/participant.hpp"

namespace fissura::uniform_flow {

namespace {

constexpr int maximum_iterations = 400;
constexpr double tolerance = 1e-14;  ///< of a volume
constexpr double greatest = 1e15;    ///< pressure that is looked at [Pa]
constexpr double first_guess = 1e6;  ///< [Pa]
constexpr double slope_step = 1;     ///< over which a slope is taken [Pa]

}  // namespace

std::set<std::string> UniformSolver::physics() const {
  return {claims::leak_off, claims::pressure_control, claims::carry_pressure};
}

void UniformSolver::prepare() {
  std::vector<std::size_t> first(length_.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto part_of = [&](std::size_t cell) {
    while (first[cell] != cell) cell = first[cell] = first[first[cell]];
    return cell;
  };
  for (const auto [a, b] : ends_) {
    const std::size_t one = part_of(a), other = part_of(b);
    first[std::max(one, other)] = std::min(one, other);
  }
  parts_.clear();
  std::vector<std::size_t> number(length_.size());
  for (std::size_t i = 0; i < length_.size(); ++i) {
    if (part_of(i) == i) {
      number[i] = parts_.size();
      parts_.emplace_back();
    }
    parts_[number[part_of(i)]].cells.push_back(i);
  }
  for (std::size_t k = 0; k < perforations_.size(); ++k)
    parts_[number[part_of(perforations_[k])]].perforations.push_back(k);
}

int UniformSolver::cover(double end) {
  const double begin = state_.time, dt = end - begin;
  cells::PieceOfFlow piece{.end = end,
                           .taken = std::vector<double>(length_.size(), 0.0),
                           .brought = std::vector<double>(perforations_.size(), 0.0),
                           .last_rate = std::vector<double>(perforations_.size(), 0.0)};
  iterations_ = 0;
  const cells::WellDemand well = well_demand(begin, end);
  set_laws(end);
  for (Part& part : parts_) {
    part.volume = 0;
    for (const std::size_t i : part.cells) part.volume += length_[i] * state_.content[i];
  }
  share_rate(well, dt);
  for (Part& part : parts_) {
    part.volume += dt * part.rate;
    for (const std::size_t k : part.perforations) {
      piece.last_rate[k] = part.rate / static_cast<double>(part.perforations.size());
      piece.brought[k] = dt * piece.last_rate[k];
    }
    double due = 0;
    for (const std::size_t i : part.cells) due += length_[i] * leak_off_demand(i, end);
    const double share = due > part.volume ? part.volume / due : 1;
    for (const std::size_t i : part.cells) piece.taken[i] = share * leak_off_demand(i, end);
    part.volume = std::max(0.0, part.volume - share * due);
    fill(part);
  }
  keep_piece(piece);
  return iterations_;
}

double UniformSolver::room(const Part& part, double pressure) const {
  double sum = 0;
  for (const std::size_t i : part.cells) sum += length_[i] * cell_content(laws_[i], pressure);
  return sum;
}

PressureReport UniformSolver::pressure_of(const Part& part, double conductance, double supply) const {
  PressureReport report;
  if (room(part, 0) >= supply) {
    report.converged = true;
    return report;
  }
  const auto excess = [&](double pressure) { return room(part, pressure) + conductance * pressure - supply; };
  double low = 0, high = std::max(first_guess, state_.pressure[part.cells.front()]);
  while (excess(high) < 0 && high < greatest) low = high, high *= 2;
  double pressure = state_.pressure[part.cells.front()];
  for (; report.iterations < maximum_iterations; ++report.iterations) {
    note_progress("pressure of a volume");
    if (!(pressure > low && pressure < high)) pressure = low + (high - low) / 2;
    const double there = excess(pressure);
    report.residual = std::abs(there) / supply;
    report.pressure = pressure;
    (there < 0 ? low : high) = pressure;
    report.converged = report.residual <= tolerance || high <= std::nextafter(low, high);
    if (report.converged) break;
    const double slope = (excess(pressure + slope_step) - there) / slope_step;
    pressure = slope > 0 ? pressure - there / slope : low;
  }
  return report;
}

void UniformSolver::share_rate(const cells::WellDemand& well, double dt) {
  std::vector<Part*> fed;
  for (Part& part : parts_) {
    part.rate = 0;
    if (!part.perforations.empty()) fed.push_back(&part);
  }
  if (fed.empty()) return;
  if (well.control == WellControl::pressure) {
    feed(well.target, dt);
    return;
  }
  if (fed.size() > 1) {
    double low = -first_guess, high = first_guess;
    while (feed(low, dt) > well.target && low > -greatest) low *= 2;
    while (feed(high, dt) < well.target && high < greatest) high *= 2;
    for (int k = 0; k < maximum_iterations && std::nextafter(low, high) < high; ++k) {
      const double middle = low + (high - low) / 2;
      (feed(middle, dt) < well.target ? low : high) = middle;
    }
    feed(high, dt);
  }
  double missing = well.target;
  for (const Part* part : fed) missing -= part->rate;
  for (Part* part : fed) part->rate += missing / static_cast<double>(fed.size());
  for (Part* part : fed) part->rate = std::max(part->rate, -part->volume / dt);
}

double UniformSolver::feed(double well_pressure, double dt) {
  double sum = 0;
  for (Part& part : parts_) {
    const double index = case_.well_index * static_cast<double>(part.perforations.size());
    if (index == 0) continue;
    const PressureReport found = pressure_of(part, dt * index, part.volume + dt * index * well_pressure);
    iterations_ += found.iterations;
    part.rate = std::max(index * (well_pressure - found.pressure), -part.volume / dt);
    sum += part.rate;
  }
  return sum;
}

/// Contents are made to sum to the volume to the last bit that can be had.
void UniformSolver::fill(const Part& part) {
  const PressureReport found = pressure_of(part, 0, part.volume);
  iterations_ += found.iterations;
  const double there = room(part, found.pressure);
  if (!found.converged || (there == 0 && part.volume > 0))
    throw SolverError(
        fmt::format("no pressure makes room for {} m2 of fluid in {} nodes at {} s: {} m2 at {} Pa",
                    part.volume, part.cells.size(), state_.time, there, found.pressure));
  for (const std::size_t i : part.cells) {
    state_.pressure[i] = found.pressure;
    state_.content[i] = there > 0 ? cell_content(laws_[i], found.pressure) * (part.volume / there) : 0;
  }
}

}  // namespace fissura::uniform_flow
