// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "structure/fracture/growth.hpp"
#include "structure/fracture/patch_selection.hpp"

/// Rock in memory whose fractures grow where a test wants them to.
namespace fissura::structure::fakes {

/// A square of `side` [m] of shale with free sides, no in-situ stress and no lines; h = 0.25 m at tips and
/// lines, 1 m far away.
Case free_case(double side);

/// Adds a straight line.
void add_line(Case& given, const std::string& name, FractureKind kind, Point begin, Point end);

/// free_case with an open slit from -2.5 to 2.5 m on y = 0.
Case free_slit();

/// A slit whose path leads at right angles onto the middle of a natural fracture.
Case slit_before_natural_fracture();

/// The same with a second slit on the other side.
Case slits_on_both_sides();

struct GrowingRock {
  explicit GrowingRock(const Case& given);

  StructureModel model;
  Geometry geometry;
  StructureState state;

  /// Displaces every node as a uniform stress [Pa] in the whole body would.
  void strain_uniformly(const InPlane<double>& stress);

  /// The same for a uniaxial tension well above the strength, so that every tip grows along `angle` [rad].
  void pull_across(double angle);

  /// What grows in the present state. @pre something does
  [[nodiscard]] GrowthPlan plan() const;

  /// Carries out a plan as the structure does on an INSERT.
  std::vector<RemeshRecord> insert(const GrowthPlan& plan);

  /// Growth of every tip along `angle` [rad] until none advances, at most `times`. @returns segments inserted
  std::size_t grow_along(double angle, int times);

  /// The tip nearest to a place.
  [[nodiscard]] FractureTip tip_near(Point place) const;

  [[nodiscard]] double h() const { return model.run_case.mesh.tip_size; }
};

/// A patch around a line, ready to be planned.
struct PlannedPlace {
  std::vector<ElementIndex> elements;
  PatchOutline outline;
  PatchMesh mesh;
};

/// The patch for a segment from `tip` to `end`. @pre it can be meshed
PlannedPlace place_segment(const GrowingRock& rock, const FractureTip& tip, Point end);

}  // namespace fissura::structure::fakes
