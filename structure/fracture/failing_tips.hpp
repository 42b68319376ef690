// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/fracture/tip_corridor.hpp"
#include "structure/fracture/wet_zone.hpp"

namespace fissura::structure {

/// The rock around tips that grow along failure paths (TipRule::damage), at coupling times.
class FailingTips {
 public:
  /// `model` must outlive this.
  explicit FailingTips(const StructureModel& model) : model_(model) {}

  /// Keeps the onset of failure to the corridors ahead of the tips and lets the fluid into their wet zones.
  /// To be called at every coupling time and after a change of the mesh.
  void tend(Geometry& geometry, StructureState& state) {
    const TipCorridors corridors = tip_corridors({model_, geometry, state});
    forbid_onset(geometry.tiles, corridors.forbidden, state.body.damage);
    wet_zone_.refresh(model_, FailureMap(model_, geometry, state), corridors.forbidden, state, geometry);
  }

  /// Gives the body its in-situ state again: before the mesh changes.
  void dry(Geometry& geometry) { wet_zone_.dry(model_, geometry); }

  /// Elements whose in-situ state the fluid has changed, ascending.
  [[nodiscard]] const std::vector<ElementIndex>& wet() const { return wet_zone_.elements(); }
  /// After a geometry was restored that holds the in-situ state of these as it was.
  void restore(std::vector<ElementIndex> wet) { wet_zone_.restore(std::move(wet)); }

 private:
  const StructureModel& model_;
  WetZone wet_zone_;
};

}  // namespace fissura::structure
