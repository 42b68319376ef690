// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>

#include "structure/structure_state.hpp"

namespace fissura::structure {

/// Whether the case lets fractures form out of rock that has failed: at tips or by nucleation.
bool forms_from_failed_rock(const Case& run_case);

/// Share of its tensile strength that each element has lost,  1 - envelope / f_t  [-]. Not the damage D: that
/// is close to 1 while much of the strength is left.
class FailureMap {
 public:
  /// @pre the case has bulk failure
  FailureMap(const StructureModel& model, const Geometry& geometry, const StructureState& state);

  /// 0 of an element that has not left its elastic range.
  [[nodiscard]] double lost(ElementIndex element) const {
    const auto found = lost_.find(element);
    return found == lost_.end() ? 0 : found->second;
  }

  [[nodiscard]] bool softening(ElementIndex element) const { return lost_.contains(element); }

  /// The greatest share among elements of `among` with their centroid within `radius` [m] of `centre`.
  [[nodiscard]] double greatest_near(const Mesh& mesh, const std::vector<ElementIndex>& among,
                                     const Point& centre, double radius) const;

  /// Elements that have lost at least `share`, ascending.
  [[nodiscard]] std::vector<ElementIndex> failed(double share) const;

 private:
  std::unordered_map<ElementIndex, double> lost_;
};

}  // namespace fissura::structure
