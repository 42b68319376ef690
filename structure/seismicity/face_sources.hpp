// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "common/byte_archive.hpp"
#include "structure/seismicity/observed_rock.hpp"
#include "structure/seismicity/source_moment.hpp"

namespace fissura::structure {

/// Contact units as seismic sources. The jump of a unit changes by what it does while it fails
/// (FaceMovement), told at the end of the interval in which that has come to more than a nanometre, and by
/// the rest, which is kept until it is asked for: the sum of all that was told and what is kept is the
/// present jump. What changes between two intervals (an insertion) is no source: it is taken note of as
/// transfer.
class FaceSources {
 public:
  /// Before the first step of an interval: takes the jumps as they are. @returns the moment that came and
  /// went since the last one, with units that are new or were left  [N m]
  PlaneTensor begin_interval(const ObservedRock& rock, double time, Joints& joints);

  /// After the last step: adds the records of units that failed, without coupling index, and clears their
  /// movement.
  void end_interval(const ObservedRock& rock, const ObservedInterval& interval, Joints& joints,
                    std::vector<SourceRecord>& records);

  /// Adds what a unit did without failing since it was last told of.
  void tell(const ObservedRock& rock, const ObservedInterval& interval, const Joints& joints, UnitIndex unit,
            std::vector<SourceRecord>& records);
  void tell_all(const ObservedRock& rock, const ObservedInterval& interval, const Joints& joints,
                std::vector<SourceRecord>& records);

  /// Units that a change of the mesh is about to touch are as new after it. @returns their moment so far,
  /// less what was not told of it [N m]
  PlaneTensor leave(const ObservedRock& rock, std::span<const UnitIndex> units);

  void save(ByteWriter& bytes) const { bytes.put(known_); }
  void restore(ByteReader& bytes) { bytes.get(known_); }
  /// Throws Error(checkpoint_unusable) unless what was restored can be of this rock.
  void require_of(const ObservedRock& rock) const { ByteReader::require(known_.size() <= rock.mesh.units.size()); }

 private:
  /// What a unit did while it failed since that was last told.
  struct Failed {
    double begin = 0, end = 0;     ///< [s]
    double path = 0;               ///< of the jump [m]; 0: nothing
    double path_time = 0;          ///< sum of path times time since `begin` [m s]
    std::array<double, 2> jump{};  ///< its change [m]
    double growth = 0;             ///< of slip or greatest separation [m]
    double peak_rate = 0;          ///< [m/s]
    PlaneTraction before;          ///< at the begin of the interval of `begin`
    bool cracked = false;          ///< cohesion wore off

    friend auto parts(EitherOf<Failed> auto& failed) {
      return std::tie(failed.begin, failed.end, failed.path, failed.path_time, failed.jump, failed.growth,
                      failed.peak_rate, failed.before, failed.cracked);
    }
  };

  struct Known {
    std::array<double, 2> jump{};    ///< u_plus - u_minus at the end of the last interval [m]
    std::array<double, 2> untold{};  ///< part of it that is not told yet [m]
    Failed failed;                   ///< part of that
    double since = 0;                ///< time it was last told of [s]
    PlaneTraction then;              ///< at that time
    PlaneTraction last;              ///< at the end of the last interval
    bool known = false;

    friend auto parts(EitherOf<Known> auto& known) {
      return std::tie(known.jump, known.untold, known.failed, known.since, known.then, known.last, known.known);
    }
  };

  static void add(const FaceMovement& movement, const ObservedInterval& interval,
                  const std::array<double, 2>& normal, const PlaneTraction& before, Failed& failed);

  std::vector<Known> known_;  ///< per unit
};

}  // namespace fissura::structure
