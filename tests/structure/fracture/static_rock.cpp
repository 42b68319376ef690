// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/structure/fracture/static_rock.hpp"

#include <Eigen/Sparse>
#include <stdexcept>

#include "structure/dynamics/triangle.hpp"

namespace fissura::structure::fakes {

namespace {

/// A node's displacement is that of its root plus `apart`.
struct Place {
  NodeIndex root = 0;
  std::array<double, 2> apart{};
};

Place place_of(const std::vector<Place>& places, NodeIndex node) {
  Place place{node, {0, 0}};
  while (places[place.root].root != place.root) {
    const Place& next = places[place.root];
    place = {next.root, {place.apart[0] + next.apart[0], place.apart[1] + next.apart[1]}};
  }
  return place;
}

std::vector<Place> places_of(const Mesh& mesh, const std::vector<Faces>& faces) {
  std::vector<Place> places(mesh.position.size());
  for (NodeIndex node = 0; node < places.size(); ++node) places[node].root = node;
  for (UnitIndex unit = 0; unit < mesh.units.size(); ++unit) {
    if (!faces[unit].together) continue;
    const Place plus = place_of(places, mesh.units[unit].plus),
                minus = place_of(places, mesh.units[unit].minus);
    if (plus.root == minus.root) continue;
    places[plus.root].root = minus.root;
    for (std::size_t axis = 0; axis < 2; ++axis)
      places[plus.root].apart[axis] = minus.apart[axis] + faces[unit].apart[axis] - plus.apart[axis];
  }
  std::vector<Place> resolved;
  for (NodeIndex node = 0; node < places.size(); ++node) resolved.push_back(place_of(places, node));
  return resolved;
}

using Stiffness = Eigen::Matrix<double, 6, 6>;

Stiffness element_stiffness(const Mesh& mesh, ElementIndex element, const Elasticity& moduli) {
  const Triangle shape = triangle(mesh, element);
  Eigen::Matrix<double, 3, 6> strain = Eigen::Matrix<double, 3, 6>::Zero();
  for (int corner = 0; corner < 3; ++corner) {
    const auto& slope = shape.slope[static_cast<std::size_t>(corner)];
    strain(0, 2 * corner) = strain(2, 2 * corner + 1) = slope[0];
    strain(1, 2 * corner + 1) = strain(2, 2 * corner) = slope[1];
  }
  const double stiff = moduli.lame + 2 * moduli.shear;
  Eigen::Matrix3d elastic;
  elastic << stiff, moduli.lame, 0, moduli.lame, stiff, 0, 0, 0, moduli.shear;
  return shape.area * strain.transpose() * elastic * strain;
}

}  // namespace

std::vector<double> displacement_at_rest(const Mesh& mesh, const Elasticity& moduli,
                                         const std::vector<Faces>& faces) {
  const std::vector<Place> places = places_of(mesh, faces);
  const std::size_t size = 2 * mesh.position.size();
  std::vector<int> free(size, -1);
  std::vector<bool> held(mesh.position.size(), true);
  for (const auto& element : mesh.elements)
    for (const NodeIndex node : element) held[places[node].root] = false;
  for (const auto& side : mesh.side_nodes)
    for (const NodeIndex node : side) held[node] = true;
  int unknowns = 0;
  for (std::size_t i = 0; i < size; ++i)
    if (!held[i / 2] && places[i / 2].root == i / 2) free[i] = unknowns++;

  Eigen::VectorXd force = Eigen::VectorXd::Zero(unknowns);
  const auto push = [&](NodeIndex node, std::size_t axis, double value) {
    if (const int row = free[2 * places[node].root + axis]; row >= 0) force[row] += value;
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Stiffness stiffness = element_stiffness(mesh, element, moduli);
    const auto& nodes = mesh.elements[element];
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const NodeIndex row = nodes[static_cast<std::size_t>(i / 2)],
                        column = nodes[static_cast<std::size_t>(j / 2)];
        const auto row_axis = static_cast<std::size_t>(i % 2), column_axis = static_cast<std::size_t>(j % 2);
        push(row, row_axis, -stiffness(i, j) * places[column].apart[column_axis]);
        const int r = free[2 * places[row].root + row_axis], c = free[2 * places[column].root + column_axis];
        if (r >= 0 && c >= 0) entries.emplace_back(r, c, stiffness(i, j));
      }
  }
  for (UnitIndex unit = 0; unit < mesh.units.size(); ++unit)
    for (std::size_t axis = 0; axis < 2 && !faces[unit].together; ++axis) {
      push(mesh.units[unit].plus, axis, faces[unit].traction[axis] * mesh.units[unit].length);
      push(mesh.units[unit].minus, axis, -faces[unit].traction[axis] * mesh.units[unit].length);
    }
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success) throw std::runtime_error("the rock is not held");
  const Eigen::VectorXd solution = solver.solve(force);
  std::vector<double> displacement(size, 0);
  for (std::size_t i = 0; i < size; ++i) {
    const Place& place = places[i / 2];
    const int row = free[2 * place.root + i % 2];
    displacement[i] = (row >= 0 ? solution[row] : 0) + place.apart[i % 2];
  }
  return displacement;
}

void press(const Mesh& mesh, std::uint32_t line, double pressure, std::vector<Faces>& faces) {
  for (UnitIndex index = 0; index < mesh.units.size(); ++index) {
    const ContactUnit& unit = mesh.units[index];
    if (unit.line != line) continue;
    faces[index] = {
        false, {}, {pressure * unit.face[0] / unit.length, pressure * unit.face[1] / unit.length}};
  }
}

}  // namespace fissura::structure::fakes
