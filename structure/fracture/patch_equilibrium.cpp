// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/patch_equilibrium.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "structure/dynamics/triangle.hpp"
#include "structure/material/rock_failure.hpp"

namespace fissura::structure {

namespace {

constexpr int maximum_iterations = 25;
constexpr double tolerance = 1e-6;
constexpr double strain_difference = 1e-9;  // far below the strain at which rock fails
constexpr double contact_stiffness = 100;   // of touching faces, in units of E' over the length of the unit

using Index = Eigen::Index;

struct UnitForce {
  std::array<double, 2> on_plus{};
  std::array<double, 2> stiffness{};  // along normal and tangent
  std::array<double, 2> normal{};
};

class PatchProblem {
 public:
  PatchProblem(const StructureModel& model, const Geometry& geometry,
               const std::vector<ElementIndex>& elements, const std::vector<ElementDamage>& records,
               const Joints& joints)
      : model_(model), mesh_(geometry.mesh), body_(geometry.body), elements_(elements), joints_(joints) {
    for (const ElementDamage& record : records)
      if (std::binary_search(elements.begin(), elements.end(), record.element))
        record_.emplace(record.element, &record);
    for (const NodeIndex node : inner_nodes(mesh_, geometry.node_elements, elements)) {
      if (body_.inverse_mass[node][0] == 0 || body_.inverse_mass[node][1] == 0) continue;
      place_.emplace(node, static_cast<Index>(nodes_.size()));
      nodes_.push_back(node);
    }
    for (UnitIndex unit = 0; unit < mesh_.units.size(); ++unit)
      if (joints.released[unit] &&
          (place_.contains(mesh_.units[unit].minus) || place_.contains(mesh_.units[unit].plus)))
        units_.push_back(unit);
  }

  PatchEquilibriumReport solve(std::vector<double>& displacement) {
    PatchEquilibriumReport report{nodes_.empty(), 0, 0};
    std::vector<double> trial = displacement;
    double largest = 0;
    while (!report.converged && report.iterations < maximum_iterations) {
      assemble(trial);
      const Eigen::VectorXd change = stiffness_.partialPivLu().solve(force_);
      if (!change.allFinite()) break;
      for (std::size_t k = 0; k < nodes_.size(); ++k)
        for (std::size_t axis = 0; axis < 2; ++axis)
          trial[2 * nodes_[k] + axis] += change[static_cast<Index>(2 * k + axis)];
      const double step = change.lpNorm<Eigen::Infinity>();
      largest = std::max(largest, step);
      report.residual = largest > 0 ? step / largest : 0;
      ++report.iterations;
      report.converged = report.residual <= tolerance;
    }
    if (report.converged) displacement = trial;
    return report;
  }

 private:
  void assemble(const std::vector<double>& displacement) {
    const auto size = static_cast<Index>(2 * nodes_.size());
    stiffness_ = Eigen::MatrixXd::Zero(size, size);
    force_ = Eigen::VectorXd::Zero(size);
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      for (std::size_t axis = 0; axis < 2; ++axis)
        force_[static_cast<Index>(2 * k + axis)] = body_.external_force[2 * nodes_[k] + axis];
    for (const ElementIndex element : elements_) add_element(element, displacement);
    for (const UnitIndex unit : units_) add_unit(unit, displacement);
  }

  // Total stress of an element, xx, yy, xy [Pa].
  [[nodiscard]] Eigen::Vector3d stress(ElementIndex element, const InPlane<double>& strain) const {
    const InSituElement& at = body_.in_situ[element];
    const auto elastic = elastic_stress(model_.moduli, strain);
    PlaneStrainStress total{{at.xx + elastic.xx, at.yy + elastic.yy, at.xy + elastic.xy},
                            at.zz + out_of_plane_stress(model_.moduli, strain)};
    if (const auto found = record_.find(element); found != record_.end())
      total = transmitted_stress(without_plastic_part(model_.moduli, total, found->second->plastic),
                                 found->second->history.damage);
    return {total.in_plane.xx - at.pore_pressure, total.in_plane.yy - at.pore_pressure, total.in_plane.xy};
  }

  void add_element(ElementIndex element, const std::vector<double>& displacement) {
    const Triangle shape = triangle(mesh_, element);
    const InPlane<double> at = strain(mesh_, element, shape, displacement);
    const Eigen::Vector3d here = stress(element, at);
    Eigen::Matrix3d tangent;
    tangent.col(0) = (stress(element, {at.xx + strain_difference, at.yy, at.xy}) - here) / strain_difference;
    tangent.col(1) = (stress(element, {at.xx, at.yy + strain_difference, at.xy}) - here) / strain_difference;
    tangent.col(2) = (stress(element, {at.xx, at.yy, at.xy + strain_difference}) - here) / strain_difference;
    Eigen::Matrix<double, 3, 6> gradient = Eigen::Matrix<double, 3, 6>::Zero();
    for (int i = 0; i < 3; ++i) {
      const auto& slope = shape.slope[static_cast<std::size_t>(i)];
      gradient(0, 2 * i) = gradient(2, 2 * i + 1) = slope[0];
      gradient(1, 2 * i + 1) = gradient(2, 2 * i) = slope[1];
    }
    const Eigen::Matrix<double, 6, 1> pull = shape.area * gradient.transpose() * here;
    const Eigen::Matrix<double, 6, 6> stiffness = shape.area * gradient.transpose() * tangent * gradient;
    for (int i = 0; i < 6; ++i) {
      const Index row = place(element, i);
      if (row < 0) continue;
      force_[row] -= pull[i];
      for (int j = 0; j < 6; ++j)
        if (const Index column = place(element, j); column >= 0) stiffness_(row, column) += stiffness(i, j);
    }
  }

  [[nodiscard]] Index place(ElementIndex element, int degree_of_freedom) const {
    return place_of_node(mesh_.elements[element][static_cast<std::size_t>(degree_of_freedom / 2)],
                         degree_of_freedom % 2);
  }
  [[nodiscard]] Index place_of_node(NodeIndex node, int axis) const {
    const auto found = place_.find(node);
    return found == place_.end() ? -1 : 2 * found->second + axis;
  }

  [[nodiscard]] UnitForce unit_force(UnitIndex index, const std::vector<double>& displacement) const {
    const ContactUnit& unit = mesh_.units[index];
    const double nx = unit.face[0] / std::hypot(unit.face[0], unit.face[1]),
                 ny = unit.face[1] / std::hypot(unit.face[0], unit.face[1]);
    const double dx = displacement[2 * std::size_t{unit.plus}] - displacement[2 * std::size_t{unit.minus}],
                 dy = displacement[2 * std::size_t{unit.plus} + 1] -
                      displacement[2 * std::size_t{unit.minus} + 1];
    const double opening = dx * nx + dy * ny, sliding = dx * ny - dy * nx;
    const CohesiveLaw& law = joints_.properties[index].cohesive;
    const double separation =
        std::max(joints_.state[index].greatest_separation, std::hypot(std::max(opening, 0.0), sliding));
    const double secant = secant_stiffness(law, separation);
    const double contact = contact_stiffness * model_.run_case.rock.plane_strain_modulus() / unit.length;
    const double along_normal = opening < 0 ? contact : secant;
    const double normal = joints_.state[index].pressure - along_normal * opening,
                 tangential = -secant * sliding;
    return {{unit.length * (normal * nx + tangential * ny), unit.length * (normal * ny - tangential * nx)},
            {unit.length * along_normal, unit.length * secant},
            {nx, ny}};
  }

  void add_unit(UnitIndex index, const std::vector<double>& displacement) {
    const UnitForce unit = unit_force(index, displacement);
    const auto [nx, ny] = unit.normal;
    const auto [kn, kt] = unit.stiffness;
    const std::array<std::array<double, 2>, 2> stiffness{
        {{kn * nx * nx + kt * ny * ny, (kn - kt) * nx * ny},
         {(kn - kt) * nx * ny, kn * ny * ny + kt * nx * nx}}};
    const std::array<NodeIndex, 2> node{mesh_.units[index].minus, mesh_.units[index].plus};
    for (std::size_t side = 0; side < 2; ++side)
      for (int i = 0; i < 2; ++i) {
        const Index row = place_of_node(node[side], i);
        if (row < 0) continue;
        force_[row] += (side == 1 ? 1 : -1) * unit.on_plus[static_cast<std::size_t>(i)];
        for (std::size_t other = 0; other < 2; ++other)
          for (int j = 0; j < 2; ++j)
            if (const Index column = place_of_node(node[other], j); column >= 0)
              stiffness_(row, column) += (side == other ? 1 : -1) *
                                         stiffness[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      }
  }

  const StructureModel& model_;
  const Mesh& mesh_;
  const Body& body_;
  const std::vector<ElementIndex>& elements_;
  const Joints& joints_;
  std::unordered_map<ElementIndex, const ElementDamage*> record_;
  std::unordered_map<NodeIndex, Index> place_;
  std::vector<NodeIndex> nodes_;
  std::vector<UnitIndex> units_;
  Eigen::MatrixXd stiffness_;
  Eigen::VectorXd force_;
};

}  // namespace

std::vector<NodeIndex> inner_nodes(const Mesh& mesh, const NodeElements& node_elements,
                                   const std::vector<ElementIndex>& elements) {
  std::vector<NodeIndex> nodes;
  for (const ElementIndex element : elements)
    for (const NodeIndex node : mesh.elements[element]) {
      const auto around = node_elements.of(node);
      if (std::all_of(around.begin(), around.end(), [&](ElementIndex other) {
            return std::binary_search(elements.begin(), elements.end(), other);
          }))
        nodes.push_back(node);
    }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

PatchEquilibriumReport equilibrate(const StructureModel& model, const Geometry& geometry,
                                   const std::vector<ElementIndex>& elements,
                                   const std::vector<ElementDamage>& records, const Joints& joints,
                                   std::vector<double>& displacement) {
  return PatchProblem(model, geometry, elements, records, joints).solve(displacement);
}

}  // namespace fissura::structure
