// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "structure/seismicity/element_sources.hpp"
#include "structure/seismicity/face_sources.hpp"

namespace fissura::structure {

/// Entities whose mesh is about to change; both ascending.
struct EntitiesThatChange {
  std::vector<UnitIndex> units;
  std::vector<ElementIndex> elements;
};

/// Observes what fails, and keeps what was told of it. Between the beginning and any later time
///   sum of all records + transferred() + what is not told yet = change of  sum M(jump) + sum V g ,
/// over faces and elements. What moves before the first interval is no source.
class SourceObserver {
 public:
  SourceObserver() = default;
  /// One that keeps and tells nothing unless it is `active`.
  explicit SourceObserver(const Seismicity& settings) : active_(settings.active) {}

  /// Forgets everything: what there is at the begin of the next interval is no source.
  void begin_anew(Joints& joints);

  /// Before the first step of an interval.
  void begin_interval(const ObservedRock& rock, double time, Joints& joints);

  /// After the elements of a step; the joints observe themselves.
  void watch(const ObservedRock& rock, double place, double step) {
    if (active_) elements_.watch(rock, place, step);
  }

  /// After the last step: makes the records of what failed.
  void end_interval(const ObservedRock& rock, const ObservedInterval& interval, Joints& joints);

  /// Makes the records of what moved without failing since it was last told of: of everything, or of
  /// what a change of the mesh will touch. At the end of an interval.
  void tell_quiet(const ObservedRock& rock, const Joints& joints);
  void tell_quiet(const ObservedRock& rock, const Joints& joints, const EntitiesThatChange& changing);

  /// The records made since this was last called, sorted by comes_before(), with the number of the coupling
  /// interval. To be called before the observer is saved.
  std::vector<SourceRecord> take(std::uint64_t interval);

  /// Around a change of the mesh. What it changes is no source: it adds to transferred() at the begin of the
  /// next interval.
  void leave(const ObservedRock& rock, const EntitiesThatChange& changing);
  void follow(const MeshChange& change);

  /// Moment that changes of the mesh have brought and taken so far: after less before [N m].
  [[nodiscard]] const PlaneTensor& transferred() const { return transferred_; }

  [[nodiscard]] bool active() const { return active_; }

  /// Everything that later records depend on.
  void save(ByteWriter& bytes) const;
  void restore(ByteReader& bytes);
  /// Throws Error(checkpoint_unusable) unless what was restored can be of this rock.
  void require_of(const ObservedRock& rock) const {
    faces_.require_of(rock);
    elements_.require_of(rock);
  }

 private:
  bool active_ = false;
  bool started_ = false;
  PlaneTensor transferred_{}, leaving_{};
  FaceSources faces_;
  ElementSources elements_;
  ObservedInterval interval_;  ///< the last one
  std::vector<SourceRecord> records_;
};

}  // namespace fissura::structure
