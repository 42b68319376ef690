// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/interval_control.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::coupler {

namespace {

constexpr std::size_t remembered_fronts = 8;
constexpr double caution = 0.9, strongest_cut = 0.5, strongest_growth = 1.3;

}  // namespace

IntervalControl::IntervalControl(const Coupling& limits, double element_size)
    : limits_(limits), element_size_(element_size) {}

void IntervalControl::start(double stable_step) {
  stable_step_ = stable_step;
  reset();
}

void IntervalControl::reset() {
  proposal_ = limits_.minimum_steps * stable_step_;
}

void IntervalControl::observe(const IntervalObservation& observation) {
  stable_step_ = observation.stable_step;
  time_ = observation.time;
  if (fronts_.empty() || observation.half_length != fronts_.back().half_length) {
    fronts_.push_back({observation.time, observation.half_length});
    if (fronts_.size() > remembered_fronts) fronts_.pop_front();
  }
  if (observation.inlet_closed) {
    reset();
    return;
  }
  const double ratio =
      observation.drift > 0 ? std::sqrt(limits_.drift_tolerance / observation.drift) : strongest_growth;
  double next = proposal_ * std::clamp(caution * ratio, strongest_cut, strongest_growth);
  if (const double speed = front_speed(); speed > 0)
    next = std::min(next, limits_.front_fraction * element_size_ / speed);
  next = std::clamp(next, limits_.minimum_steps * stable_step_, limits_.maximum_steps * stable_step_);
  if (limits_.maximum_interval > 0) next = std::min(next, limits_.maximum_interval);
  proposal_ = next;
}

void IntervalControl::save(ByteWriter& bytes) const {
  bytes.put(stable_step_);
  bytes.put(proposal_);
  bytes.put(time_);
  bytes.put(std::vector<Front>(fronts_.begin(), fronts_.end()));
}

void IntervalControl::restore(ByteReader& bytes) {
  std::vector<Front> fronts;
  bytes.get(stable_step_);
  bytes.get(proposal_);
  bytes.get(time_);
  bytes.get(fronts);
  fronts_.assign(fronts.begin(), fronts.end());
}

double IntervalControl::front_speed() const {
  if (fronts_.size() < 2) return 0;
  const double elapsed = time_ - fronts_.front().time;
  return elapsed > 0 ? (fronts_.back().half_length - fronts_.front().half_length) / elapsed : 0;
}

}  // namespace fissura::coupler
