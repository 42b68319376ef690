// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/mass_scaling.hpp"

#include <algorithm>
#include <cmath>

namespace fissura::structure {

namespace {

constexpr double least_growth = 1.2;     // smaller changes are not worth a new step size
constexpr double growth_limit = 1.5;     // per coupling interval
constexpr double shortest_event = 0.02;  // [s], of an event without ramp

}  // namespace

double quasi_static_mass_scale(const Rock& rock, double loading_ratio, double time, double half_length) {
  const double needed_speed = 4 * half_length / (loading_ratio * time);
  return rock.shear_modulus() / rock.density / (needed_speed * needed_speed);
}

MassScaling::MassScaling(const Dynamics& dynamics, const Rock& rock)
    : dynamics_(dynamics), rock_(rock), scale_(dynamics.initial_mass_scale) {}

void MassScaling::note_pump_event(double time, double ramp) {
  event_ = PumpEvent{time, ramp};
}

double MassScaling::target(double time, double half_length) const {
  const double pumping =
      std::clamp(quasi_static_mass_scale(rock_, dynamics_.loading_ratio, time, half_length),
                 dynamics_.initial_mass_scale, dynamics_.maximum_mass_scale);
  if (!event_) return pumping;
  const double since = std::max({time - event_->time, event_->ramp, shortest_event});
  const double after_event =
      quasi_static_mass_scale(rock_, dynamics_.event_loading_ratio, since, half_length);
  return std::min(pumping, std::max(1.0, after_event));
}

bool MassScaling::update(double time, double half_length) {
  const double wanted = target(time, half_length);
  const bool changes = wanted < scale_ || wanted >= least_growth * scale_;
  if (changes) scale_ = std::min(wanted, growth_limit * scale_);
  return changes;
}

void MassScaling::save(ByteWriter& bytes) const {
  bytes.put(scale_);
  bytes.put(event_);
}

void MassScaling::restore(ByteReader& bytes) {
  bytes.get(scale_);
  bytes.get(event_);
  ByteReader::require(scale_ > 0 && std::isfinite(scale_));
}

}  // namespace fissura::structure
