// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/source_chains.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace fissura::coupler {

namespace {

bool later(const Source& a, const Source& b) {
  return comes_before(b, a);
}

/// Numbers by which records differ that comes_before() does not tell apart.
auto remainder(const SourceRecord& r) {
  return std::tie(r.geometry, r.line, r.failing, r.interval, r.centroid_time, r.position, r.extent,
                  r.element_size, r.normal, r.jump, r.moment, r.pseudo_moment, r.measure, r.peak_rate,
                  r.shear_before, r.shear_after, r.normal_before, r.normal_after, r.fluid_pressure,
                  r.mass_scale, r.fracture);
}

}  // namespace

std::vector<std::uint32_t> order_of(const std::vector<SourceRecord>& records) {
  struct Place {
    double end;
    std::uint32_t index;
  };
  std::vector<Place> places(records.size());
  for (std::uint32_t i = 0; i < records.size(); ++i) places[i] = {records[i].end, i};
  std::sort(places.begin(), places.end(), [&records](const Place& a, const Place& b) {
    if (a.end != b.end) return a.end < b.end;
    const SourceRecord& left = records[a.index];
    const SourceRecord& right = records[b.index];
    if (comes_before(left, right)) return true;
    if (comes_before(right, left)) return false;
    return remainder(left) < remainder(right);
  });
  std::vector<std::uint32_t> order;
  order.reserve(places.size());
  for (const Place& place : places) order.push_back(place.index);
  return order;
}

void WaitingSources::push(const Source& source) {
  heap_.push_back(source);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

void WaitingSources::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), later);
  heap_.pop_back();
}

std::vector<Source> WaitingSources::sources() const {
  std::vector<Source> sources = heap_;
  std::sort(sources.begin(), sources.end(),
            [](const Source& a, const Source& b) { return comes_before(a, b); });
  return sources;
}

std::size_t SourceChains::KeyHash::operator()(const Key& key) const {
  const std::uint64_t code =
      (key.entity.number << 2) | (key.entity.bulk << 1) | static_cast<std::uint64_t>(key.source_class);
  return std::hash<std::uint64_t>()(code ^ (key.entity.geometry << 40));
}

void SourceChains::add(const SourceRecord& record, WaitingSources& closed) {
  const auto [place, is_new] = open_.try_emplace({entity_of(record), class_of(record.kind)}, record, rules_);
  if (is_new) return;
  if (place->second.goes_on_in(record)) {
    place->second.add(record, rules_);
  } else {
    closed.push(place->second.closed(rules_));
    place->second = OpenSource(record, rules_);
  }
}

void SourceChains::close_before(double time, WaitingSources& closed) {
  for (auto source = open_.begin(); source != open_.end();) {
    if (source->second.listens_at(time)) {
      ++source;
    } else {
      closed.push(source->second.closed(rules_));
      source = open_.erase(source);
    }
  }
}

double SourceChains::earliest_time() const {
  double earliest = std::numeric_limits<double>::infinity();
  for (const auto& [key, source] : open_) earliest = std::min(earliest, source.first_end());
  return earliest;
}

void SourceChains::add_to(TensorSum& moment) const {
  for (const OpenSource& source : open_sources()) moment.add(source.moment());
}

std::vector<OpenSource> SourceChains::open_sources() const {
  std::vector<std::pair<Key, const OpenSource*>> sorted;
  for (const auto& [key, source] : open_) sorted.emplace_back(key, &source);
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<OpenSource> sources;
  sources.reserve(sorted.size());
  for (const auto& [key, source] : sorted) sources.push_back(*source);
  return sources;
}

void SourceChains::put_back(const std::vector<OpenSource>& sources) {
  for (const OpenSource& source : sources)
    open_.try_emplace({source.entity(), source.source_class()}, source);
}

}  // namespace fissura::coupler
