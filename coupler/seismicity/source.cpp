// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/source.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "coupler/seismicity/moment_tensor.hpp"

namespace fissura::coupler {

namespace {

// What no mesh and no model has [m].
constexpr double smallest_length = 1e-9, greatest_length = 1e9;

// Of a shear wave. Fewer part the softening of a joint, which the scaled mass lets swing, into bursts.
constexpr double passages_of_rest = 100;

/// Opening and slip of a crack that has the moment: n.M.n = (lambda + 2 mu) A opening, t.M.n = mu A slip.
std::array<double, 2> equivalent_jump(const SourceRecord& record, double area, const SourceRules& rules) {
  const auto [nx, ny] = record.normal;
  const auto [xx, yy, zz, xy] = record.moment;
  const double across = nx * nx * xx + ny * ny * yy + 2 * nx * ny * xy;
  const double along = nx * ny * (xx - yy) + (ny * ny - nx * nx) * xy;
  return {across / ((rules.lame + 2 * rules.shear) * area), along / (rules.shear * area)};
}

}  // namespace

static_assert(sizeof(Source) == 32 * sizeof(double) + 3 * sizeof(std::uint64_t) + 4 * sizeof(std::uint32_t));

Entity entity_of(const SourceRecord& record) {
  const bool bulk = in_bulk(record.kind);
  return {record.entity, bulk ? record.geometry : 0, bulk ? 1u : 0u};
}

bool comes_before(const Source& a, const Source& b) {
  const auto key = [](const Source& s) {
    return std::tuple(s.time, s.bulk == 0, s.number, s.geometry, s.source_class, s.begin);
  };
  return key(a) < key(b);
}

bool SourceRules::seismic(const SourceRecord& record) const {
  if (!record.failing) return false;
  const double rate = record.peak_rate * std::sqrt(record.mass_scale);
  const bool rock = in_bulk(record.kind) || record.kind == SourceKind::new_crack;
  return rate >= (rock ? thresholds.failure_rate : thresholds.slip_rate);
}

bool SourceRules::seismic(const Source& source) const {
  return source.contact == 0 || source.shear_drop() >= thresholds.stress_drop;
}

double SourceRules::cluster_radius(double element_size) const {
  return thresholds.cluster_radius > 0 ? thresholds.cluster_radius : 1.5 * element_size;
}

double SourceRules::cluster_time(double element_size, double mass_scale) const {
  if (thresholds.cluster_time > 0) return thresholds.cluster_time;
  return cluster_radius(element_size) * std::sqrt(mass_scale) / shear_wave_speed;
}

double SourceRules::rest_time(double element_size, double mass_scale) const {
  return thresholds.rest_time > 0 ? thresholds.rest_time
                                  : passages_of_rest * cluster_time(element_size, mass_scale);
}

double SourceRules::telling_time(double element_size, double mass_scale) const {
  return passages_of_rest * 1.5 * element_size * std::sqrt(mass_scale) / shear_wave_speed;
}

bool is_possible(const Source& source, SourceStage stage) {
  const auto finite = [](const auto& numbers) {
    return std::all_of(std::begin(numbers), std::end(numbers),
                       [](double number) { return std::isfinite(number); });
  };
  const auto is_size = [](double length) { return length >= smallest_length && length <= greatest_length; };
  const double numbers[] = {
      source.scalar_sum,    source.begin,        source.end,          source.slip,
      source.opening,       source.area,         source.length,       source.shear_before,
      source.shear_after,   source.pressure_sum, source.peak_rate,    source.time,
      source.centroid_time, source.reach,        source.cluster_time, source.cluster_radius};
  const bool in_place = std::all_of(source.position.begin(), source.position.end(),
                                    [](double place) { return std::abs(place) <= greatest_length; });
  const bool words = source.source_class <= SourceClass::shear && source.bulk <= 1 && source.contact <= 1 &&
                     (source.fracture <= SourceFracture::grown || source.fracture == SourceFracture::none);
  const bool times =
      source.begin <= source.end && (stage == SourceStage::going_on || source.reach >= source.time);
  return finite(numbers) && finite(source.moment) && finite(source.pseudo_moment) && finite(source.plane) &&
         in_place && words && times && source.records > 0 && is_size(source.smallest_size) &&
         is_size(source.greatest_size) && source.smallest_size <= source.greatest_size &&
         source.mass_scale >= 1 && std::isfinite(source.mass_scale) &&
         (stage == SourceStage::going_on || is_size(source.cluster_radius));
}

bool OpenSource::is_possible() const {
  return coupler::is_possible(source_, SourceStage::going_on) && first_end_ >= source_.begin &&
         first_end_ <= source_.end && goes_on_until_ >= source_.end && listens_until_ >= goes_on_until_ &&
         std::isfinite(listens_until_) && std::isfinite(scalar_sum_.value()) &&
         std::isfinite(weighted_end_.value()) && std::isfinite(weighted_centroid_.value());
}

OpenSource::OpenSource(const SourceRecord& first, const SourceRules& rules) {
  const Entity entity = entity_of(first);
  source_.number = entity.number;
  source_.geometry = entity.geometry;
  source_.bulk = entity.bulk;
  source_.source_class = class_of(first.kind);
  source_.contact = first.kind == SourceKind::contact_slip ? 1 : 0;
  source_.fracture = first.fracture;
  source_.line = first.line;
  source_.position = first.position;
  source_.begin = first.begin;
  source_.end = first_end_ = first.end;
  source_.shear_before = first.shear_before;
  source_.smallest_size = source_.greatest_size = first.element_size;
  add(first, rules);
}

void OpenSource::add(const SourceRecord& record, const SourceRules& rules) {
  const double weight = scalar_moment(record.moment);
  moment_.add(record.moment);
  pseudo_moment_.add(record.pseudo_moment);
  scalar_sum_.add(weight);
  weighted_end_.add(weight * (record.end - first_end_));
  weighted_centroid_.add(weight * (record.centroid_time - first_end_));

  const auto [nx, ny] = record.normal;
  source_.plane[0] += weight * nx * nx;
  source_.plane[1] += weight * ny * ny;
  source_.plane[2] += weight * nx * ny;
  const bool bulk = in_bulk(record.kind);
  const double area = bulk ? record.extent / record.element_size : record.extent;
  const double length = bulk ? record.element_size : record.extent / rules.thickness;
  if (bulk) {
    const auto [opening, slip] = equivalent_jump(record, area, rules);
    source_.opening += opening;
    source_.slip += slip;
  } else {
    source_.opening += record.jump[0] * nx + record.jump[1] * ny;
    source_.slip += record.jump[0] * ny - record.jump[1] * nx;
  }
  source_.area = std::max(source_.area, area);
  source_.length = std::max(source_.length, length);

  source_.begin = std::min(source_.begin, record.begin);
  source_.end = std::max(source_.end, record.end);
  source_.shear_after = record.shear_after;
  source_.pressure_sum += record.fluid_pressure;
  source_.peak_rate = std::max(source_.peak_rate, record.peak_rate);
  source_.smallest_size = std::min(source_.smallest_size, record.element_size);
  source_.greatest_size = std::max(source_.greatest_size, record.element_size);
  source_.mass_scale = std::max(source_.mass_scale, record.mass_scale);
  source_.interval = std::max(source_.interval, record.interval);
  ++source_.records;
  goes_on_until_ = source_.end + rules.rest_time(source_.greatest_size, source_.mass_scale);
  listens_until_ = goes_on_until_ + rules.telling_time(source_.greatest_size, source_.mass_scale);
}

Source OpenSource::closed(const SourceRules& rules) const {
  Source source = source_;
  source.moment = moment_.value();
  source.pseudo_moment = pseudo_moment_.value();
  source.scalar_sum = scalar_sum_.value();
  const double weight = source.scalar_sum;
  const double middle = 0.5 * (source.end - first_end_);
  const double end = weight > 0 ? weighted_end_.value() / weight : middle;
  const double centroid = weight > 0 ? weighted_centroid_.value() / weight : middle;
  source.time = std::clamp(first_end_ + end, first_end_, source.end);
  source.centroid_time = std::clamp(first_end_ + centroid, source.begin, source.end);
  source.cluster_radius = rules.cluster_radius(source.greatest_size);
  source.cluster_time = rules.cluster_time(source.greatest_size, source.mass_scale);
  source.reach = source.time + source.cluster_time;
  return source;
}

}  // namespace fissura::coupler
