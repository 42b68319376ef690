// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/energy.hpp"

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

double kinetic_energy(const Body& body, const std::vector<double>& velocity, double mass_scale) {
  double twice = 0;
  for (std::size_t node = 0; node < body.mass.size(); ++node) {
    const double vx = velocity[2 * node], vy = velocity[2 * node + 1];
    twice += body.mass[node] * (vx * vx + vy * vy);
  }
  return 0.5 * mass_scale * twice;
}

double strain_energy(const Mesh& mesh, const Elasticity& moduli, const std::vector<double>& displacement) {
  double sum = 0;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const auto shape = triangle(mesh, element);
    sum += shape.area * elastic_energy_density(moduli, strain(mesh, element, shape, displacement));
  }
  return sum;
}

double in_situ_work(const Mesh& mesh, const Body& body, const std::vector<double>& displacement) {
  double sum = 0;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const auto shape = triangle(mesh, element);
    const auto deformation = strain(mesh, element, shape, displacement);
    const InSituElement& in_situ = body.in_situ[element];
    const double pressure = in_situ.pore_pressure;
    sum += shape.area * ((in_situ.xx - pressure) * deformation.xx + (in_situ.yy - pressure) * deformation.yy +
                         in_situ.xy * deformation.xy);
  }
  return sum;
}

double external_work(const Body& body, const std::vector<double>& displacement) {
  double sum = 0;
  for (std::size_t dof = 0; dof < displacement.size(); ++dof)
    sum += body.external_force[dof] * displacement[dof];
  return sum;
}

namespace {

// C^-1 : s = (s - nu / (1 + nu) tr(s) I) / (2 G), applied twice to the tensile part.
double released_density(const Elasticity& moduli, const PlaneStrainStress& undamaged, double damage) {
  const double poissons_ratio = 0.5 * moduli.lame / (moduli.lame + moduli.shear);
  const auto& stress = undamaged.in_plane;
  const auto tensile = tensile_part(stress);
  const double volumetric =
      poissons_ratio / (1 + poissons_ratio) * (stress.xx + stress.yy + undamaged.out_of_plane);
  const double twice = (tensile.xx * (stress.xx - volumetric) + tensile.yy * (stress.yy - volumetric) +
                        2 * tensile.xy * stress.xy) /
                       (2 * moduli.shear);
  return 0.5 * damage * twice;
}

// Energy of the whole strain less that of its elastic part: mean of the two stresses on the plastic strain.
double plastic_density(const PlaneStrainStress& elastic, const PlaneStrainStress& undamaged,
                       const PlasticHistory& plastic) {
  const auto on_plastic_strain = [&plastic](const PlaneStrainStress& stress) {
    return stress.in_plane.xx * plastic.strain.xx + stress.in_plane.yy * plastic.strain.yy +
           stress.in_plane.xy * plastic.strain.xy + stress.out_of_plane * plastic.strain_zz;
  };
  return 0.5 * (on_plastic_strain(elastic) + on_plastic_strain(undamaged));
}

}  // namespace

double released_energy(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                       const std::vector<double>& displacement, const std::vector<ElementDamage>& records) {
  double sum = 0;
  for (const auto& [element, history, plastic] : records) {
    const PlaneStrainStress elastic = undamaged_stress(mesh, body, moduli, element, displacement);
    const PlaneStrainStress undamaged = without_plastic_part(moduli, elastic, plastic);
    sum += triangle(mesh, element).area * (released_density(moduli, undamaged, history.damage) +
                                           plastic_density(elastic, undamaged, plastic));
  }
  return sum;
}

double failure_dissipation(const Mesh& mesh, const RockFailure& law,
                           const std::vector<ElementDamage>& records) {
  double sum = 0;
  for (const auto& [element, history, plastic] : records)
    sum += triangle(mesh, element).area * dissipated_energy(law, history, plastic);
  return sum;
}

}  // namespace fissura::structure
