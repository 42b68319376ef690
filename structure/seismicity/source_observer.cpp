// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/seismicity/source_observer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/log.hpp"

namespace fissura::structure {

namespace {

constexpr double unnoticed = 1;  // a magnitude of -6 [N m]

void log_transfer(const PlaneTensor& change) {
  if (size_of(change) > unnoticed)
    log::info(
        fmt::format("an insertion changed the moment of failed rock and faces by {:.3g} {:.3g} {:.3g} "
                    "{:.3g} N m (xx, yy, zz, xy): no source",
                    change[0], change[1], change[2], change[3]));
}

}  // namespace

void SourceObserver::begin_anew(Joints& joints) {
  std::fill(joints.movement.begin(), joints.movement.end(), FaceMovement{});
  *this = active_ ? SourceObserver(Seismicity{}) : SourceObserver();
}

void SourceObserver::begin_interval(const ObservedRock& rock, double time, Joints& joints) {
  if (!active_) return;
  const PlaneTensor came = faces_.begin_interval(rock, time, joints) + elements_.begin_interval(rock, time);
  if (started_ && came != leaving_) {
    log_transfer(came - leaving_);
    transferred_ = transferred_ + (came - leaving_);
  }
  leaving_ = {};
  started_ = true;
}

void SourceObserver::end_interval(const ObservedRock& rock, const ObservedInterval& interval,
                                  Joints& joints) {
  if (!active_) return;
  interval_ = interval;
  faces_.end_interval(rock, interval, joints, records_);
  elements_.end_interval(rock, interval, records_);
}

void SourceObserver::tell_quiet(const ObservedRock& rock, const Joints& joints) {
  if (!active_) return;
  faces_.tell_all(rock, interval_, joints, records_);
  elements_.tell_all(rock, interval_, records_);
}

void SourceObserver::tell_quiet(const ObservedRock& rock, const Joints& joints,
                                const EntitiesThatChange& changing) {
  if (!active_) return;
  for (const UnitIndex unit : changing.units) faces_.tell(rock, interval_, joints, unit, records_);
  for (const ElementIndex element : changing.elements) elements_.tell(rock, interval_, element, records_);
}

std::vector<SourceRecord> SourceObserver::take(std::uint64_t interval) {
  std::vector<SourceRecord> records = std::exchange(records_, {});
  for (SourceRecord& record : records) record.interval = interval;
  std::sort(records.begin(), records.end(), comes_before);
  return records;
}

void SourceObserver::leave(const ObservedRock& rock, const EntitiesThatChange& changing) {
  if (!active_) return;
  leaving_ = leaving_ + faces_.leave(rock, changing.units) + elements_.leave(rock, changing.elements);
}

void SourceObserver::follow(const MeshChange& change) {
  elements_.follow(change);
}

void SourceObserver::save(ByteWriter& bytes) const {
  bytes.put(started_);
  bytes.put(transferred_);
  bytes.put(leaving_);
  bytes.put(interval_);
  faces_.save(bytes);
  elements_.save(bytes);
}

void SourceObserver::restore(ByteReader& bytes) {
  bytes.get(started_);
  bytes.get(transferred_);
  bytes.get(leaving_);
  bytes.get(interval_);
  faces_.restore(bytes);
  elements_.restore(bytes);
}

}  // namespace fissura::structure
