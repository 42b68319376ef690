// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/sections.hpp"

namespace fissura::input {

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
  mesh.far_size = table.quantity("far_size", dimension::length, positive);
  mesh.corridor = table.quantity("corridor", dimension::length, positive);
  mesh.gradation = table.number("gradation", fraction);
  mesh.seed = table.natural_number("seed", mesh.seed);
  table.refuse_unknown_keys();
  return mesh;
}

Rock read_rock(TableReader& document) {
  TableReader table = document.table("rock");
  Rock rock;
  rock.density = table.quantity("density", dimension::density, positive);
  rock.youngs_modulus = table.quantity("youngs_modulus", dimension::stress, positive);
  rock.poissons_ratio = table.number("poissons_ratio", between(-1, 0.5));
  rock.tensile_strength = table.quantity("tensile_strength", dimension::stress, positive);
  rock.fracture_energy = table.quantity("fracture_energy", dimension::energy_per_area, positive);
  rock.biot_coefficient = table.number("biot_coefficient", from_to(0, 1), rock.biot_coefficient);
  table.refuse_unknown_keys();
  return rock;
}

}  // namespace fissura::input
