// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/structure/pulled_plate.hpp"

#include <algorithm>
#include <cmath>

#include "structure/dynamics/central_difference.hpp"
#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/energy.hpp"
#include "structure/dynamics/stable_step.hpp"
#include "structure/dynamics/triangle.hpp"
#include "tests/fakes/structure/shale_case.hpp"

namespace fissura::structure {

namespace {

constexpr double duration = 0.04;  // [s]: a hundred transits of a wave, so slow
constexpr double damping = 0.1;

Case pulling(double stretch) {
  Case settings = fakes::shale_case();
  settings.bulk_failure.active = true;
  settings.bulk_failure.softening = Softening::linear;
  settings.boundary.south = {BoundaryKind::displacement, {0, -stretch / 2}, duration};
  settings.boundary.north = {BoundaryKind::displacement, {0, stretch / 2}, duration};
  return settings;
}

// Force on the sides of a body in equilibrium, from the mean stress in it [N/m].
double force(const PulledPlate& plate, const Mesh& mesh, const std::vector<ElementStress>& stress) {
  double sum = 0;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    sum += triangle(mesh, element).area * stress[element].in_plane.yy;
  return sum / plate.lattice.height;
}

}  // namespace

Pulled pull(const PulledPlate& plate) {
  const Case settings = pulling(plate.stretch);
  const Mesh mesh = fakes::lattice_mesh(plate.lattice);
  const Body body = build_body(mesh, settings);
  const Tiles tiles = build_tiles(mesh, body, {});
  const Elasticity moduli = elasticity(settings.rock);
  const RockFailure law = rock_failure(settings.rock, settings.bulk_failure);
  State state = state_at_rest(body, tiles);
  plate.prepare(mesh, tiles, law, state.damage);
  CentralDifference dynamics(body, tiles, moduli, law, 1);
  const auto stiffest = stiffest_element(mesh, moduli, settings.rock.density);
  const int steps =
      static_cast<int>(std::ceil(duration / stable_step(stiffest.frequency_squared, 0, {0.8, 1, damping})));

  const double ligament = plate.lattice.width - plate.lattice.notch;
  const double strength = settings.rock.tensile_strength * ligament;
  constexpr int steps_per_sample = 20;
  double work = 0, before = 0, now = 0, greatest = 0;
  for (int k = 1; k <= steps; ++k) {
    dynamics.advance(state, {duration / steps, duration * k / steps, 1, damping});
    if (k % steps_per_sample != 0) continue;
    now =
        force(plate, mesh,
              effective_stress(mesh, body, moduli, state.displacement, damage_records(tiles, state.damage)));
    work += 0.5 * (before + now) * plate.stretch * steps_per_sample / steps;
    greatest = std::max(greatest, now);
    before = now;
  }
  const auto records = damage_records(tiles, state.damage);
  const double left = strain_energy(mesh, moduli, state.displacement) -
                      released_energy(mesh, body, moduli, state.displacement, records);
  const double energy = settings.rock.fracture_energy * ligament;
  return {failure_dissipation(mesh, law, records) / energy, (work - left) / energy, greatest / strength,
          now / strength};
}

bool reaches(const Mesh& mesh, ElementIndex element, double height) {
  const double rounding = 1e-9;  // [m]
  bool below = false, above = false;
  for (const NodeIndex node : mesh.elements[element]) {
    below = below || mesh.position[node][1] <= height + rounding;
    above = above || mesh.position[node][1] >= height - rounding;
  }
  return below && above;
}

}  // namespace fissura::structure
