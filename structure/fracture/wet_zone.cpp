// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/wet_zone.hpp"

#include <algorithm>
#include <map>

#include "structure/dynamics/in_situ.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/connected_elements.hpp"
#include "structure/fracture/fracture_tips.hpp"

namespace fissura::structure {

namespace {

InSituElement raised(const Mesh& mesh, const Case& run_case, ElementIndex element, double pressure) {
  const InSituState state = in_situ_state(run_case, centroid(mesh, element));
  const double rise = std::max(0.0, pressure - state.pore_pressure);
  return {static_cast<float>(state.stress.xx + rise), static_cast<float>(state.stress.yy + rise),
          static_cast<float>(state.stress.xy), static_cast<float>(state.out_of_plane + rise),
          static_cast<float>(state.pore_pressure + rise)};
}

}  // namespace

void WetZone::refresh(const StructureModel& model, const FailureMap& map,
                      const std::vector<ElementIndex>& dry_elements, const StructureState& state,
                      Geometry& geometry) {
  constexpr double no_fluid = 0;
  const Mesh& mesh = geometry.mesh;
  const double radius = model.run_case.growth.wet_zone * model.run_case.mesh.tip_size;
  std::map<ElementIndex, double> pressure;
  for (const ElementIndex element : wet_) pressure.emplace(element, no_fluid);
  wet_.clear();
  for (const FractureTip& tip : fracture_tips(mesh)) {
    const double at_tip = adjacent_pressure(mesh, state.joints, tip);
    if (at_tip <= in_situ_state(model.run_case, tip.position).pore_pressure) continue;
    for (const ElementIndex element :
         connected_elements(mesh, geometry.node_elements, tip.node, tip.position, radius)) {
      if (!map.softening(element) && std::binary_search(dry_elements.begin(), dry_elements.end(), element))
        continue;
      double& wet = pressure[element];
      wet = std::max(wet, at_tip);
      wet_.push_back(element);
    }
  }
  std::sort(wet_.begin(), wet_.end());
  wet_.erase(std::unique(wet_.begin(), wet_.end()), wet_.end());
  std::vector<ElementIndex> changed;
  for (const auto& [element, fluid] : pressure) {
    geometry.body.in_situ[element] = raised(mesh, model.run_case, element, fluid);
    changed.push_back(element);
  }
  refresh_in_situ(geometry.body, changed, geometry.tiles);
}

void WetZone::dry(const StructureModel& model, Geometry& geometry) {
  constexpr double no_fluid = 0;
  for (const ElementIndex element : wet_)
    geometry.body.in_situ[element] = raised(geometry.mesh, model.run_case, element, no_fluid);
  refresh_in_situ(geometry.body, wet_, geometry.tiles);
  wet_.clear();
}

}  // namespace fissura::structure
