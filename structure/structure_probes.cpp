// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/structure_probes.hpp"

#include <algorithm>
#include <cmath>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/fracture/connected_elements.hpp"
#include "structure/joints/face_pair.hpp"

namespace fissura::structure {

namespace {

constexpr double sizes_around = 2;  // of the elements whose stress counts
constexpr double least_spread =
    1e-6;  // determinant of the spread of their centroids that a plane needs, in sizes^4

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

/// Sums for the plane  s = a + b x + c y  through weighted values, x and y from the place where it is asked
/// for.
class PlaneFit {
 public:
  void add(double weight, double x, double y, const InPlane<double>& stress) {
    weight_ += weight;
    x_ += weight * x;
    y_ += weight * y;
    xx_ += weight * x * x;
    xy_ += weight * x * y;
    yy_ += weight * y * y;
    add(stress, weight, stress_);
    add(stress, weight * x, stress_x_);
    add(stress, weight * y, stress_y_);
  }

  /// Its value at the place; the mean where the values do not determine a plane. @param radius  of the places
  /// [m]
  [[nodiscard]] InPlane<double> value(double radius) const {
    const double x = x_ / weight_, y = y_ / weight_;
    const double xx = xx_ / weight_ - x * x, xy = xy_ / weight_ - x * y, yy = yy_ / weight_ - y * y;
    const double determinant = xx * yy - xy * xy;
    const double square = radius * radius;
    const bool determined = determinant > least_spread * square * square;
    const auto component = [&](double InPlane<double>::*which) {
      const double mean = stress_.*which / weight_;
      if (!determined) return mean;
      const double sx = stress_x_.*which / weight_ - x * mean, sy = stress_y_.*which / weight_ - y * mean;
      return mean - x * (yy * sx - xy * sy) / determinant - y * (xx * sy - xy * sx) / determinant;
    };
    return {component(&InPlane<double>::xx), component(&InPlane<double>::yy),
            component(&InPlane<double>::xy)};
  }

 private:
  static void add(const InPlane<double>& stress, double factor, InPlane<double>& sum) {
    sum.xx += factor * stress.xx;
    sum.yy += factor * stress.yy;
    sum.xy += factor * stress.xy;
  }

  double weight_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0;
  InPlane<double> stress_{0, 0, 0}, stress_x_{0, 0, 0}, stress_y_{0, 0, 0};
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
    PlaneFit fit;
    for (const ElementIndex element : place.around) {
      const Point middle = centroid(mesh, element);
      fit.add(element_area(mesh, element), middle[0] - at[0], middle[1] - at[1],
              stress_of(model, geometry, state, records, element));
    }
    values.stress = fit.value(size_of(mesh, place.element));
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
