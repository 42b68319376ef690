// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "common/byte_archive.hpp"
#include "structure/mesh/mesh_change.hpp"
#include "structure/seismicity/observed_rock.hpp"
#include "structure/seismicity/source_moment.hpp"

namespace fissura::structure {

/// Failed elements as seismic sources. The inelastic strain of an element is measured by
///   e = D kappa + |eps_p| ;
/// it fails in steps in which e grows, and an interval in which it grew is told at its end with all that the
/// stress glut changed in it. Between, a damaged element opens and closes along its secant: that is kept
/// until it is asked for. The sum of all that was told and what is kept is the present glut. An insertion is
/// no source: what it changes is taken note of as transfer.
class ElementSources {
 public:
  /// Before the first step of an interval. @returns the moment of failed elements that are new since the last
  /// one, or were left  [N m]
  PlaneTensor begin_interval(const ObservedRock& rock, double time);

  /// After a step: looks which elements failed in it, at records only. @param place  of the end of the step
  /// in the interval, (0, 1]  @param step  its length [s]
  void watch(const ObservedRock& rock, double place, double step);

  /// After the last step: adds the records of elements that failed, without coupling index.
  void end_interval(const ObservedRock& rock, const ObservedInterval& interval,
                    std::vector<SourceRecord>& records);

  /// Adds what an element did without failing since it was last told of, if it ever failed.
  void tell(const ObservedRock& rock, const ObservedInterval& interval, ElementIndex element,
            std::vector<SourceRecord>& records);
  void tell_all(const ObservedRock& rock, const ObservedInterval& interval,
                std::vector<SourceRecord>& records);

  /// Elements that a change of the mesh is about to remove. @returns their moment so far, less what was not
  /// told of it [N m]
  PlaneTensor leave(const ObservedRock& rock, std::span<const ElementIndex> elements);

  /// After the mesh changed: elements have other numbers.
  void follow(const MeshChange& change);

  void save(ByteWriter& bytes) const { bytes.put(known_); }
  void restore(ByteReader& bytes) {
    bytes.get(known_);
    anew_ = true;
  }
  /// Throws Error(checkpoint_unusable) unless what was restored can be of this rock.
  void require_of(const ObservedRock& rock) const;

 private:
  struct Known {
    ElementIndex element = 0;
    PlaneTensor glut{};      ///< at the end of the last interval [Pa]
    PlaneTensor quiet{};     ///< part of it that came without failure and is not told yet [Pa]
    double since = 0;        ///< time it was last told of [s]
    PlaneStrainStress then;  ///< transmitted at that time [Pa]
    PlaneStrainStress last;  ///< and at the end of the last interval [Pa]

    friend auto parts(EitherOf<Known> auto& known) {
      return std::tie(known.element, known.glut, known.quiet, known.since, known.then, known.last);
    }
  };

  /// Of one record of a tile, in the present interval.
  struct Growth {
    double cracking = 0, plastic = 0;  ///< its parts at the begin of the interval [-]
    double volume = 0;                 ///< plastic, likewise [-]
    double damage = 0;                 ///< likewise [-]
    double size = 0, size_time = 0;    ///< sum of growth, and of growth times place [-]
    double first = 0, last = 0;        ///< places of the first and the last step with growth
    double peak_rate = 0;              ///< of e [1/s]
  };

  struct Failed {
    ElementIndex element = 0;
    std::uint32_t tile = 0;
    std::uint16_t record = 0;
  };

  [[nodiscard]] static std::vector<Failed> failed_elements(const ObservedRock& rock);
  void note_onsets(const ObservedRock& rock, std::uint32_t tile);
  Known* find(ElementIndex element);
  void tell(const ObservedRock& rock, const ObservedInterval& interval, Known& known,
            const DamageHistory& history, std::vector<SourceRecord>& records) const;

  std::vector<Known> known_;                 ///< ascending in the element
  std::vector<Failed> failed_;               ///< elements with a record, ascending
  std::vector<Known> onsets_;                ///< of the present interval
  std::vector<std::vector<Growth>> growth_;  ///< per tile, of each of its records
  std::vector<std::vector<double>> seen_;    ///< likewise, e as last seen: all that most steps need
  double begin_ = 0;                         ///< of the present interval [s]
  bool anew_ = true;                         ///< the mesh is another one than in the last interval
};

}  // namespace fissura::structure
