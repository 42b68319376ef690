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

double released_energy(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                       const std::vector<double>& displacement, const std::vector<ElementDamage>& records) {
  const double poissons_ratio = 0.5 * moduli.lame / (moduli.lame + moduli.shear);
  const double compliance = 0.5 / moduli.shear;
  double sum = 0;
  for (const auto& [element, history] : records) {
    const auto [stress, out_of_plane] = undamaged_stress(mesh, body, moduli, element, displacement);
    const auto tensile = tensile_part(stress);
    // C^-1 : s = (s - nu / (1 + nu) tr(s) I) / (2 G)
    const double volumetric = poissons_ratio / (1 + poissons_ratio) * (stress.xx + stress.yy + out_of_plane);
    const double density = compliance * (tensile.xx * (stress.xx - volumetric) +
                                         tensile.yy * (stress.yy - volumetric) + 2 * tensile.xy * stress.xy);
    sum += 0.5 * triangle(mesh, element).area * history.damage * density;
  }
  return sum;
}

double damage_dissipation(const Mesh& mesh, const RankineDamage& law,
                          const std::vector<ElementDamage>& records) {
  double sum = 0;
  for (const auto& [element, history] : records)
    sum += triangle(mesh, element).area * dissipated_energy(law, history);
  return sum;
}

}  // namespace fissura::structure
