// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/fracture/failing_rock.hpp"

#include "structure/dynamics/triangle.hpp"
#include "structure/material/crack_band.hpp"

namespace fissura::structure::fakes {

Case failing_slit() {
  Case given = free_slit();
  given.bulk_failure.active = true;
  given.bulk_failure.softening = Softening::linear;
  given.growth.tip = TipRule::damage;
  given.growth.nucleation = true;
  return given;
}

void fail(GrowingRock& rock, double share, const std::function<bool(const Point&)>& where) {
  constexpr std::array<double, 2> normal{0, 1};
  const Mesh& mesh = rock.geometry.mesh;
  const RankineDamage law = rock_failure(rock.model.run_case.rock, rock.model.run_case.bulk_failure).tension;
  std::vector<ElementDamage> records;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    if (!where(centroid(mesh, element))) continue;
    const auto& [a, b, c] = mesh.elements[element];
    const double band = crack_band_length({mesh.position[a], mesh.position[b], mesh.position[c]}, normal);
    ElementDamage record{element, undamaged_band(law, normal, band), {}};
    grow_damage(law, strain_of_lost_strength(law, record.history.tensile_strength, band, share),
                record.history);
    records.push_back(record);
  }
  rock.state.body.damage = damage_from_records(rock.geometry.tiles, records);
}

RockNow now(const GrowingRock& rock) {
  return {rock.model, rock.geometry, rock.state};
}

FailureMap map(const GrowingRock& rock) {
  return {rock.model, rock.geometry, rock.state};
}

}  // namespace fissura::structure::fakes
