// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_probes.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/connected_elements.hpp"
#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

namespace {

constexpr double sizes_around = 2;  // of the elements whose stress counts

/// The three shape functions of an element at a point.
std::array<double, 3> shape_functions(const Mesh& mesh, ElementIndex element, const Point& at) {
  const Triangle shape = triangle(mesh, element);
  const Point middle = centroid(mesh, element);
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i)
    values[i] = 1.0 / 3 + shape.slope[i][0] * (at[0] - middle[0]) + shape.slope[i][1] * (at[1] - middle[1]);
  return values;
}

/// The element that holds the point, or the one it is least outside of.
ElementIndex element_at(const Mesh& mesh, const Point& at) {
  ElementIndex best = 0;
  double least = -INFINITY;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const auto values = shape_functions(mesh, element, at);
    const double smallest = *std::min_element(values.begin(), values.end());
    if (smallest <= least) continue;
    least = smallest;
    best = element;
  }
  return best;
}

/// Edge length of the equilateral triangle of the same area [m].
double size_of(const Mesh& mesh, ElementIndex element) {
  return std::sqrt(4 / std::sqrt(3.0) * element_area(mesh, element));
}

std::optional<UnitIndex> joint_near(const Mesh& mesh, const Point& at, double distance) {
  std::optional<UnitIndex> nearest;
  for (UnitIndex unit = 0; unit < mesh.units.size(); ++unit) {
    const Point& place = mesh.vertices[mesh.units[unit].vertex].position;
    const double here = std::hypot(place[0] - at[0], place[1] - at[1]);
    if (here > distance || (nearest && here == distance)) continue;
    distance = here;
    nearest = unit;
  }
  return nearest;
}

/// Stresses of elements around a place, weighted by area, for a polynomial through them.
class StressFit {
 public:
  /// @param size  of the elements [m];  `x`, `y` from the place [m]
  explicit StressFit(double size) : size_(size) {}

  void add(double area, double x, double y, const InPlane<double>& stress) {
    const double weight = std::sqrt(area);
    const double u = x / size_, v = y / size_;
    for (const double term : {1.0, u, v, u * u, u * v, v * v}) terms_.push_back(weight * term);
    for (const double value : {stress.xx, stress.yy, stress.xy}) values_.push_back(weight * value);
  }

  /// At the place itself, of the polynomial of the highest degree, at most two, that twice as many elements
  /// as it has terms determine.
  [[nodiscard]] InPlane<double> value() const {
    const auto count = static_cast<Eigen::Index>(values_.size() / 3);
    const Eigen::Index terms = count >= 12 ? 6 : count >= 6 ? 3 : 1;
    using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const Table> basis(terms_.data(), count, 6), values(values_.data(), count, 3);
    const Eigen::MatrixXd fit = Eigen::MatrixXd(basis.leftCols(terms)).colPivHouseholderQr().solve(values);
    return {fit(0, 0), fit(0, 1), fit(0, 2)};
  }

 private:
  double size_;
  std::vector<double> terms_, values_;
};

/// Effective stress of an element, `records` of failure regarded.
InPlane<double> stress_of(const StructureModel& model, const Geometry& geometry, const StructureState& state,
                          const std::vector<ElementDamage>& records, ElementIndex element) {
  const ElementStress whole =
      undamaged_stress(geometry.mesh, geometry.body, model.moduli, element, state.body.displacement);
  const auto found = std::lower_bound(records.begin(), records.end(), element,
                                      [](const ElementDamage& a, ElementIndex b) { return a.element < b; });
  if (found == records.end() || found->element != element) return whole.in_plane;
  return transmitted_stress(without_plastic_part(model.moduli, whole, found->plastic), found->history.damage)
      .in_plane;
}

}  // namespace

Probes::Place Probes::locate(const Geometry& geometry, const Point& at) {
  const Mesh& mesh = geometry.mesh;
  Place place;
  place.element = element_at(mesh, at);
  place.shape = shape_functions(mesh, place.element, at);
  const double size = size_of(mesh, place.element);
  place.around = connected_elements(mesh, geometry.node_elements, mesh.elements[place.element][0], at,
                                    sizes_around * size);
  if (!std::binary_search(place.around.begin(), place.around.end(), place.element))
    place.around = {place.element};
  place.joint = joint_near(mesh, at, size);
  return place;
}

std::vector<ProbeValues> Probes::observe(const StructureModel& model, const Geometry& geometry,
                                         const StructureState& state) {
  const Mesh& mesh = geometry.mesh;
  if (any() && geometry_ != geometry.number) {
    places_.clear();
    for (const Probe& probe : probes_) places_.push_back(locate(geometry, probe.position));
    geometry_ = geometry.number;
  }
  const std::vector<ElementDamage> records = damage_records(geometry.tiles, state.body.damage);
  std::vector<ProbeValues> seen;
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    const Place& place = places_[k];
    const Point& at = probes_[k].position;
    ProbeValues& values = seen.emplace_back();
    values.joint = place.joint;
    StressFit fit(size_of(mesh, place.element));
    for (const ElementIndex element : place.around) {
      const Point middle = centroid(mesh, element);
      fit.add(element_area(mesh, element), middle[0] - at[0], middle[1] - at[1],
              stress_of(model, geometry, state, records, element));
    }
    values.stress = fit.value();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        values.displacement[axis] +=
            place.shape[i] * state.body.displacement[2 * std::size_t{mesh.elements[place.element][i]} + axis];
  }
  return seen;
}

nlohmann::json probes_json(const std::vector<ProbeValues>& probes, const Joints& joints) {
  nlohmann::json list = nlohmann::json::array();
  for (const ProbeValues& probe : probes) {
    nlohmann::json& entry = list.emplace_back(nlohmann::json{{"stress_xx", probe.stress.xx},
                                                             {"stress_yy", probe.stress.yy},
                                                             {"stress_xy", probe.stress.xy},
                                                             {"displacement_x", probe.displacement[0]},
                                                             {"displacement_y", probe.displacement[1]},
                                                             {"slip", nullptr},
                                                             {"opening", nullptr},
                                                             {"normal_traction", nullptr},
                                                             {"shear_traction", nullptr}});
    if (!probe.joint) continue;
    const JointState& state = joints.state[*probe.joint];
    const ContactTraction traction =
        contact_traction(joints.properties[*probe.joint], state, joints.released[*probe.joint] != 0);
    entry["slip"] = state.sliding;
    entry["opening"] = state.opening;
    entry["normal_traction"] = traction.normal;
    entry["shear_traction"] = traction.shear;
  }
  return list;
}

}  // namespace fissura::structure
