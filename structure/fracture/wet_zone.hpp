// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "structure/fracture/failure_map.hpp"

namespace fissura::structure {

/// The fluid in the failing rock ahead of a tip. A failed element that kept its pore pressure would be closed
/// by the far field and hold the fluid back; the dry zone ahead of the fluid is far shorter than an element
/// (Garagash & Detournay 2000). Around a tip the pressure p of the fluid on the last open vertex therefore
/// replaces that of the pores, wherever failure has started or may start:
///   effective stress + dp I ,  pore pressure + dp ,   dp = max(0, p - p_pores) .
/// The total stress of undamaged rock stays; a crack without strength transmits -p.
class WetZone {
 public:
  /// Wets the elements within Growth::wet_zone of every tip but for those in `dry_elements` (ascending), with
  /// the pressures of the faces now. Those wetted before and not any more have their in-situ state again.
  void refresh(const StructureModel& model, const FailureMap& map,
               const std::vector<ElementIndex>& dry_elements, const StructureState& state,
               Geometry& geometry);

  /// Gives all elements their in-situ state again: before the mesh changes.
  void dry(const StructureModel& model, Geometry& geometry);

  /// The elements that are wet, ascending.
  [[nodiscard]] const std::vector<ElementIndex>& elements() const { return wet_; }
  /// After a geometry was restored in which these are wet.
  void restore(std::vector<ElementIndex> elements) { wet_ = std::move(elements); }

 private:
  std::vector<ElementIndex> wet_;
};

}  // namespace fissura::structure
