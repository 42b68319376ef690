// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/structure/naive_structure.hpp"

#include <algorithm>
#include <cmath>

#include "structure/material/failure_trigger.hpp"

namespace fissura::structure::fakes {

namespace {

double longest_edge(const Mesh& mesh) {
  double longest = 0;
  for (const auto& element : mesh.elements)
    for (int corner = 0; corner < 3; ++corner) {
      const Point &p = mesh.position[element[corner]], &q = mesh.position[element[(corner + 1) % 3]];
      longest = std::max(longest, std::hypot(q[0] - p[0], q[1] - p[1]));
    }
  return longest;
}

}  // namespace

NaiveStructure::NaiveStructure(const Mesh& mesh, const Body& body, const Elasticity& moduli,
                               std::optional<RockFailure> law)
    : nodes_(mesh.position.size()), elements_(mesh.elements.size()), moduli_(moduli), law_(law) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    nodes_[i].position = mesh.position[i];
    nodes_[i].external_force = {body.external_force[2 * i], body.external_force[2 * i + 1]};
    nodes_[i].inverse_mass = body.inverse_mass[i];
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const auto& in_situ = body.in_situ[e];
    elements_[e] = {mesh.elements[e],
                    {in_situ.xx, in_situ.yy, in_situ.xy},
                    in_situ.zz,
                    in_situ.pore_pressure,
                    false,
                    {},
                    {}};
  }
  if (law_) lowest_strength_ = lowest_strength(law_->tension, longest_edge(mesh));
}

void NaiveStructure::set_displacement(const std::vector<double>& displacement) {
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    nodes_[i].displacement = {displacement[2 * i], displacement[2 * i + 1]};
}

void NaiveStructure::set_velocity(const std::vector<double>& velocity) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) nodes_[i].velocity = {velocity[2 * i], velocity[2 * i + 1]};
}

void NaiveStructure::set_damage(const std::vector<ElementDamage>& records) {
  for (const auto& [element, history, plastic] : records) {
    elements_[element].cracked = true;
    elements_[element].history = history;
    elements_[element].plastic = plastic;
  }
}

void NaiveStructure::add_force(Element& element) {
  Node* const node[3] = {&nodes_[element.node[0]], &nodes_[element.node[1]], &nodes_[element.node[2]]};
  double slope[3][2];
  const auto& p = node[0]->position;
  const auto& q = node[1]->position;
  const auto& r = node[2]->position;
  const double double_area = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
  const double scale = 1 / double_area;
  for (int i = 0; i < 3; ++i) {
    const auto& next = node[(i + 1) % 3]->position;
    const auto& previous = node[(i + 2) % 3]->position;
    slope[i][0] = (next[1] - previous[1]) * scale;
    slope[i][1] = (previous[0] - next[0]) * scale;
  }
  InPlane<double> strain{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    strain.xx += slope[i][0] * node[i]->displacement[0];
    strain.yy += slope[i][1] * node[i]->displacement[1];
    strain.xy += slope[i][0] * node[i]->displacement[1] + slope[i][1] * node[i]->displacement[0];
  }
  auto stress = elastic_stress(moduli_, strain);
  stress.xx += element.in_situ.xx;
  stress.yy += element.in_situ.yy;
  stress.xy += element.in_situ.xy;
  if (law_) {
    const double out_of_plane = element.out_of_plane + out_of_plane_stress(moduli_, strain);
    const RankineSurface surface{lowest_strength_};
    double limit = surface.radius_limit(mohr_centre(stress));
    if (law_->shear)
      limit = std::min(
          limit, MohrCoulombLimit(law_->shear->surface).radius_limit(mohr_centre(stress), out_of_plane));
    if (!element.cracked && exceeds(mohr_radius_squared(stress), limit))
      if (const auto onset = failure_onset(*law_, {stress, out_of_plane}, {p, q, r})) {
        element.cracked = true;
        element.history = *onset;
      }
    if (element.cracked) {
      if (law_->shear)
        stress = failed_stress(*law_, {stress, out_of_plane}, element.history, element.plastic).in_plane;
      else
        stress = damaged_stress(law_->tension, stress, element.history);
    }
  }
  stress.xx -= element.pore_pressure;
  stress.yy -= element.pore_pressure;
  for (int i = 0; i < 3; ++i) {
    node[i]->force[0] -= 0.5 * double_area * (stress.xx * slope[i][0] + stress.xy * slope[i][1]);
    node[i]->force[1] -= 0.5 * double_area * (stress.xy * slope[i][0] + stress.yy * slope[i][1]);
  }
}

void NaiveStructure::advance(const Step& step) {
  const double size = step.size, impulse = step.size / step.mass_scale, damping = step.damping;
  for (Node& node : nodes_) node.force = node.external_force;
  for (Element& element : elements_) add_force(element);
  for (Node& node : nodes_)
    for (int axis = 0; axis < 2; ++axis) {
      const double force = node.force[axis], drag = damping * std::abs(force);
      const double before = node.velocity[axis];
      node.velocity[axis] += impulse * node.inverse_mass[axis] *
                             (force - (before > 0   ? drag
                                       : before < 0 ? -drag
                                                    : 0));
      node.displacement[axis] += size * node.velocity[axis];
    }
}

std::vector<double> NaiveStructure::displacement() const {
  std::vector<double> values;
  for (const Node& node : nodes_)
    values.insert(values.end(), node.displacement.begin(), node.displacement.end());
  return values;
}

std::vector<double> NaiveStructure::velocity() const {
  std::vector<double> values;
  for (const Node& node : nodes_) values.insert(values.end(), node.velocity.begin(), node.velocity.end());
  return values;
}

std::size_t NaiveStructure::cracked_elements() const {
  return static_cast<std::size_t>(std::count_if(elements_.begin(), elements_.end(),
                                                [](const Element& element) { return element.cracked; }));
}

}  // namespace fissura::structure::fakes
