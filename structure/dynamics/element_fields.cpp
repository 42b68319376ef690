// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/element_fields.hpp"

#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

ElementStress undamaged_stress(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                               ElementIndex element, const std::vector<double>& displacement) {
  const auto deformation = strain(mesh, element, triangle(mesh, element), displacement);
  const auto elastic = elastic_stress(moduli, deformation);
  const InSituElement& in_situ = body.in_situ[element];
  return {{in_situ.xx + elastic.xx, in_situ.yy + elastic.yy, in_situ.xy + elastic.xy},
          in_situ.zz + out_of_plane_stress(moduli, deformation)};
}

std::vector<ElementStress> effective_stress(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                                            const std::vector<double>& displacement,
                                            const std::vector<ElementDamage>& records) {
  std::vector<ElementStress> stress(mesh.elements.size());
  for (ElementIndex element = 0; element < stress.size(); ++element)
    stress[element] = undamaged_stress(mesh, body, moduli, element, displacement);
  for (const auto& [element, history, plastic] : records)
    stress[element] =
        transmitted_stress(without_plastic_part(moduli, stress[element], plastic), history.damage);
  return stress;
}

std::vector<Principal> principal_stresses(const std::vector<ElementStress>& stress) {
  std::vector<Principal> result;
  result.reserve(stress.size());
  for (const auto& element : stress) result.push_back(principal(element.in_plane));
  return result;
}

std::vector<double> damage_field(const Mesh& mesh, const std::vector<ElementDamage>& records) {
  std::vector<double> damage(mesh.elements.size(), 0);
  for (const ElementDamage& record : records) damage[record.element] = record.history.damage;
  return damage;
}

std::vector<double> plastic_strain_field(const Mesh& mesh, const std::vector<ElementDamage>& records) {
  std::vector<double> size(mesh.elements.size(), 0);
  for (const ElementDamage& record : records) size[record.element] = size_of(record.plastic);
  return size;
}

}  // namespace fissura::structure
