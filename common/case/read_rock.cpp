// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/case/sections.hpp"

namespace fissura::input {

Rock read_rock(TableReader& document) {
  TableReader table = document.table("rock");
  Rock rock;
  rock.density = table.quantity("density", dimension::density, positive);
  rock.youngs_modulus = table.quantity("youngs_modulus", dimension::stress, positive);
  rock.poissons_ratio = table.number("poissons_ratio", between(-1, 0.5));
  rock.tensile_strength = table.quantity("tensile_strength", dimension::stress, positive);
  rock.fracture_energy = table.quantity("fracture_energy", dimension::energy_per_area, positive);
  rock.biot_coefficient = table.number("biot_coefficient", from_to(0, 1), rock.biot_coefficient);
  rock.friction_coefficient = table.number("friction_coefficient", not_negative, rock.friction_coefficient);
  table.refuse_unknown_keys();
  return rock;
}

}  // namespace fissura::input
