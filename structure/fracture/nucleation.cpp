// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/nucleation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "structure/dynamics/element_fields.hpp"
#include "structure/dynamics/triangle.hpp"
#include "structure/mesh/segment_tree.hpp"

namespace fissura::structure {

namespace {

// In units of tip_size.
constexpr double away_from_fractures = 3;
constexpr double away_from_sides = 1.5;
constexpr double beside = 0.9;
constexpr int steps_per_segment = 2;
constexpr int longest_half = 4;

using Cluster = std::vector<ElementIndex>;

bool away_from_all_fractures(const Mesh& mesh, const Point& at, double distance) {
  return std::all_of(mesh.edges.begin(), mesh.edges.end(), [&](const FractureEdge& edge) {
    return distance_to_segment(at, mesh.vertices[edge.begin].position, mesh.vertices[edge.end].position) >
           distance;
  });
}

std::vector<Cluster> clusters(const Mesh& mesh, const NodeElements& node_elements, const Cluster& failed) {
  std::unordered_set<ElementIndex> left(failed.begin(), failed.end());
  std::vector<Cluster> found;
  for (const ElementIndex start : failed) {
    if (left.erase(start) == 0) continue;
    Cluster cluster{start};
    for (std::size_t k = 0; k < cluster.size(); ++k)
      for (const NodeIndex node : mesh.elements[cluster[k]])
        for (const ElementIndex next : node_elements.of(node))
          if (left.erase(next) != 0) cluster.push_back(next);
    std::sort(cluster.begin(), cluster.end());
    found.push_back(std::move(cluster));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Cluster& a, const Cluster& b) { return a.size() > b.size(); });
  return found;
}

class Nucleation {
 public:
  Nucleation(const RockNow& rock, const FailureMap& map)
      : rock_(rock), mesh_(rock.geometry.mesh), map_(map), h_(rock.model.run_case.mesh.tip_size) {}

  [[nodiscard]] std::optional<Nucleus> nucleus(const Cluster& cluster) const {
    const auto along = direction(cluster);
    if (extent(cluster, along) < rock_.model.run_case.growth.failure_length * h_) return std::nullopt;
    const Point middle = middle_of(cluster);
    const NodeIndex node = nearest_node(cluster, middle);
    std::vector<Point> line = half({middle, node, {-along[0], -along[1]}}, cluster);
    std::reverse(line.begin(), line.end());
    line.push_back(middle);
    const std::vector<Point> forward = half({middle, node, along}, cluster);
    line.insert(line.end(), forward.begin(), forward.end());
    if (line.size() < 3 || static_cast<double>(line.size() - 1) < rock_.model.run_case.growth.failure_length)
      return std::nullopt;
    return Nucleus{std::move(line), node};
  }

 private:
  [[nodiscard]] std::array<double, 2> direction(const Cluster& cluster) const {
    InPlane<double> sum{0, 0, 0};
    for (const ElementIndex element : cluster) {
      const double area = triangle(mesh_, element).area;
      const auto stress = undamaged_stress(mesh_, rock_.geometry.body, rock_.model.moduli, element,
                                           rock_.state.body.displacement)
                              .in_plane;
      sum = {sum.xx + area * stress.xx, sum.yy + area * stress.yy, sum.xy + area * stress.xy};
    }
    const auto across = principal(sum).direction;
    return {-across[1], across[0]};
  }

  [[nodiscard]] double extent(const Cluster& cluster, const std::array<double, 2>& along) const {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const ElementIndex element : cluster)
      for (const NodeIndex node : mesh_.elements[element]) {
        const double at = along[0] * mesh_.position[node][0] + along[1] * mesh_.position[node][1];
        least = std::min(least, at);
        greatest = std::max(greatest, at);
      }
    return greatest - least;
  }

  // Of the element nearest to the mean of all, so that it lies in the cluster whatever its shape.
  [[nodiscard]] Point middle_of(const Cluster& cluster) const {
    Point mean{};
    double areas = 0;
    for (const ElementIndex element : cluster) {
      const double area = triangle(mesh_, element).area;
      const Point at = centroid(mesh_, element);
      mean = {mean[0] + area * at[0], mean[1] + area * at[1]};
      areas += area;
    }
    mean = {mean[0] / areas, mean[1] / areas};
    const auto distance = [&](ElementIndex element) {
      const Point at = centroid(mesh_, element);
      return std::hypot(at[0] - mean[0], at[1] - mean[1]);
    };
    return centroid(
        mesh_, *std::min_element(cluster.begin(), cluster.end(),
                                 [&](ElementIndex a, ElementIndex b) { return distance(a) < distance(b); }));
  }

  [[nodiscard]] NodeIndex nearest_node(const Cluster& cluster, const Point& at) const {
    double least = std::numeric_limits<double>::infinity();
    NodeIndex nearest = 0;
    for (const ElementIndex element : cluster)
      for (const NodeIndex node : mesh_.elements[element]) {
        const double distance = std::hypot(mesh_.position[node][0] - at[0], mesh_.position[node][1] - at[1]);
        if (distance >= least) continue;
        least = distance;
        nearest = node;
      }
    return nearest;
  }

  [[nodiscard]] bool possible(const Point& at, const Cluster& cluster) const {
    const Domain& domain = rock_.model.run_case.domain;
    const double inside = std::min(domain.width / 2 - std::abs(at[0]), domain.height / 2 - std::abs(at[1]));
    return inside > away_from_sides * h_ && away_from_all_fractures(mesh_, at, away_from_fractures * h_) &&
           map_.greatest_near(mesh_, cluster, at, beside * h_) >= rock_.model.run_case.growth.failure_damage;
  }

  // Points of the line beyond its middle.
  [[nodiscard]] std::vector<Point> half(const MarchStart& start, const Cluster& cluster) const {
    const std::vector<Point> path = march(rock_, start, longest_half * steps_per_segment);
    std::vector<Point> line;
    for (std::size_t k = steps_per_segment; k < path.size() && possible(path[k], cluster);
         k += steps_per_segment)
      line.push_back(path[k]);
    return line;
  }

  const RockNow& rock_;
  const Mesh& mesh_;
  const FailureMap& map_;
  double h_;
};

}  // namespace

std::vector<Nucleus> nuclei(const RockNow& rock, const FailureMap& map) {
  const Mesh& mesh = rock.geometry.mesh;
  const double distance = away_from_fractures * rock.model.run_case.mesh.tip_size;
  std::vector<ElementIndex> failed = map.failed(rock.model.run_case.growth.failure_damage);
  std::erase_if(failed, [&](ElementIndex element) {
    return !away_from_all_fractures(mesh, centroid(mesh, element), distance);
  });
  const Nucleation nucleation(rock, map);
  std::vector<Nucleus> found;
  for (const Cluster& cluster : clusters(mesh, rock.geometry.node_elements, failed))
    if (auto nucleus = nucleation.nucleus(cluster)) found.push_back(std::move(*nucleus));
  return found;
}

}  // namespace fissura::structure
