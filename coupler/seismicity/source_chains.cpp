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

void SourceChains::open(const Key& key, const OpenSource& source) {
  beginnings_.push_back({source.listens_until(), source.first_end(), key});
  listening_.push(beginnings_.back());
}

bool SourceChains::is_open(const Note& note) const {
  const auto place = open_.find(note.key);
  return place != open_.end() && place->second.first_end() == note.first_end;
}

void SourceChains::drop_closed_beginnings() {
  while (!beginnings_.empty() && !is_open(beginnings_.front())) beginnings_.pop_front();
}

void SourceChains::add(const SourceRecord& record, WaitingSources& closed) {
  const Key key{entity_of(record), class_of(record.kind)};
  const auto [place, is_new] = open_.try_emplace(key, record, rules_);
  if (is_new) return open(key, place->second);
  if (place->second.goes_on_in(record)) return place->second.add(record, rules_);
  closed.push(place->second.closed(rules_));
  place->second = OpenSource(record, rules_);
  open(key, place->second);
  drop_closed_beginnings();
}

void SourceChains::close_before(double time, WaitingSources& closed) {
  while (!listening_.empty() && listening_.top().until < time) {
    const Note note = listening_.top();
    listening_.pop();
    if (!is_open(note)) continue;
    const auto place = open_.find(note.key);
    if (place->second.listens_at(time)) {
      listening_.push({place->second.listens_until(), note.first_end, note.key});
    } else {
      closed.push(place->second.closed(rules_));
      open_.erase(place);
    }
  }
  drop_closed_beginnings();
}

double SourceChains::earliest_time() const {
  return beginnings_.empty() ? std::numeric_limits<double>::infinity() : beginnings_.front().first_end;
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

void SourceChains::put_back(std::vector<OpenSource> sources) {
  std::stable_sort(sources.begin(), sources.end(),
                   [](const OpenSource& a, const OpenSource& b) { return a.first_end() < b.first_end(); });
  for (const OpenSource& source : sources) {
    const Key key{source.entity(), source.source_class()};
    if (open_.try_emplace(key, source).second) open(key, source);
  }
}

}  // namespace fissura::coupler
