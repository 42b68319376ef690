// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

constexpr double tip_sizes_of_a_tip_radius = 4;
constexpr double gradation_at_a_tip = 0.4;

Refinement read_refinement(TableReader& table) {
  Refinement refinement;
  refinement.size = table.quantity("size", dimension::length, positive);
  refinement.west = table.quantity("west", dimension::length, any_value);
  refinement.east = table.quantity("east", dimension::length, any_value);
  refinement.south = table.quantity("south", dimension::length, any_value);
  refinement.north = table.quantity("north", dimension::length, any_value);
  table.refuse_unknown_keys();
  return refinement;
}

}  // namespace

Domain read_domain(TableReader& document) {
  TableReader table = document.table("domain");
  Domain domain;
  domain.width = table.quantity("width", dimension::length, positive);
  domain.height = table.quantity("height", dimension::length, positive);
  domain.thickness = table.quantity("thickness", dimension::length, positive);
  table.refuse_unknown_keys();
  return domain;
}

MeshControls read_mesh(TableReader& document) {
  TableReader table = document.table("mesh");
  MeshControls mesh;
  mesh.fracture_size = table.quantity("fracture_size", dimension::length, positive);
  mesh.natural_size = table.quantity("natural_size", dimension::length, positive, mesh.fracture_size);
  mesh.far_size = table.quantity("far_size", dimension::length, positive);
  mesh.corridor = table.quantity("corridor", dimension::length, positive);
  mesh.gradation = table.number("gradation", fraction);
  mesh.seed = table.natural_number("seed", mesh.seed);
  mesh.tip_size = table.quantity("tip_size", dimension::length, positive, mesh.fracture_size);
  mesh.tip_radius =
      table.quantity("tip_radius", dimension::length, positive, tip_sizes_of_a_tip_radius * mesh.tip_size);
  mesh.tip_gradation = table.number("tip_gradation", fraction, gradation_at_a_tip);
  if (table.has("lattice_angle"))
    mesh.lattice_angle = table.quantity("lattice_angle", dimension::angle, any_value);
  for (TableReader& refinement : table.optional_tables("refinement"))
    mesh.refinements.push_back(read_refinement(refinement));
  table.refuse_unknown_keys();
  return mesh;
}

}  // namespace fissura::input
