// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/dynamics/frequency_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/errors.hpp"

namespace fissura::structure {

namespace {

using CornerValues = std::vector<std::array<double, 3>>;

constexpr int share_improvements = 2;
constexpr int local_share_improvements = 4;

Triangle triangle_with_area(const Mesh& mesh, ElementIndex element) {
  const Triangle shape = triangle(mesh, element);
  if (shape.area > 0) return shape;
  const Point position = centroid(mesh, element);
  throw SolverError(
      fmt::format("an element with positive area was expected, element {} at ({} m, {} m) has {} m2", element,
                  position[0], position[1], shape.area));
}

std::vector<double> sum_at_nodes(const Mesh& mesh, const CornerValues& values) {
  std::vector<double> sum(mesh.position.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int i = 0; i < 3; ++i) sum[mesh.elements[e][i]] += values[e][i];
  return sum;
}

// Up to a factor, the trace of a corner's block of the stiffness matrix.
double corner_stiffness(const Triangle& shape, int i) {
  return shape.area * (shape.slope[i][0] * shape.slope[i][0] + shape.slope[i][1] * shape.slope[i][1]);
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

// The elements around the changed nodes, and what of them can change: their shares at those nodes.
class ChangedShares {
 public:
  ChangedShares(const Mesh& mesh, const NodeElements& elements, const MeshChange& change)
      : mesh_(mesh), elements_(elements), nodes_(changed_nodes(change)) {
    for (const NodeIndex node : nodes_)
      region_.insert(region_.end(), elements.of(node).begin(), elements.of(node).end());
    std::sort(region_.begin(), region_.end());
    region_.erase(std::unique(region_.begin(), region_.end()), region_.end());
    for (const ElementIndex element : region_) {
      shapes_.push_back(triangle_with_area(mesh, element));
      const Triangle& shape = shapes_.back();
      weight_.push_back({corner_stiffness(shape, 0), corner_stiffness(shape, 1), corner_stiffness(shape, 2)});
      auto& mass = node_mass_.emplace_back();
      for (int i = 0; i < 3; ++i) mass[i] = area_around(mesh.elements[element][i]) / 3;
    }
  }

  void choose(const Elasticity& moduli, double density, FrequencyBound& bound) {
    double best = std::numeric_limits<double>::infinity();
    CornerValues share(region_.size());
    std::vector<double> squared(region_.size());
    for (int round = 0; round <= local_share_improvements && !region_.empty(); ++round) {
      share_out(bound, share);
      for (std::size_t k = 0; k < region_.size(); ++k) {
        std::array<double, 3> mass{};
        for (int i = 0; i < 3; ++i) mass[i] = density * node_mass_[k][i] * share[k][i];
        squared[k] = element_frequency_squared(shapes_[k], moduli, mass);
        for (double& value : weight_[k]) value *= squared[k];
      }
      if (largest(squared) >= best) continue;
      best = largest(squared);
      best_share_ = share;
      best_squared_ = squared;
    }
    for (std::size_t k = 0; k < region_.size(); ++k) {
      bound.share[region_[k]] = best_share_[k];
      bound.squared[region_[k]] = best_squared_[k];
    }
  }

 private:
  [[nodiscard]] double area_around(NodeIndex node) const {
    double area = 0;
    for (const ElementIndex element : elements_.of(node)) area += triangle(mesh_, element).area;
    return area;
  }

  void share_out(const FrequencyBound& bound, CornerValues& share) const {
    std::vector<double> sum(nodes_.size(), 0);
    for (std::size_t k = 0; k < region_.size(); ++k)
      for (int i = 0; i < 3; ++i)
        if (const std::size_t n = place(mesh_.elements[region_[k]][i]); n < nodes_.size())
          sum[n] += weight_[k][i];
    for (std::size_t k = 0; k < region_.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const std::size_t n = place(mesh_.elements[region_[k]][i]);
        share[k][i] = n < nodes_.size() ? weight_[k][i] / sum[n] : bound.share[region_[k]][i];
      }
  }

  // Among the changed nodes, or their number.
  [[nodiscard]] std::size_t place(NodeIndex node) const {
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
    return found != nodes_.end() && *found == node ? static_cast<std::size_t>(found - nodes_.begin())
                                                   : nodes_.size();
  }

  const Mesh& mesh_;
  const NodeElements& elements_;
  std::vector<NodeIndex> nodes_;
  std::vector<ElementIndex> region_;
  std::vector<Triangle> shapes_;
  CornerValues weight_, node_mass_, best_share_;  // node_mass_ is that of unit density
  std::vector<double> best_squared_;
};

}  // namespace

FrequencyBound bound_frequencies(const Mesh& mesh, const Elasticity& moduli, double density) {
  std::vector<Triangle> shapes;
  CornerValues areas, weight;
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
    const Triangle& shape = shapes.emplace_back(triangle_with_area(mesh, element));
    areas.push_back({shape.area, shape.area, shape.area});
    weight.push_back({corner_stiffness(shape, 0), corner_stiffness(shape, 1), corner_stiffness(shape, 2)});
  }
  const auto area_at_nodes = sum_at_nodes(mesh, areas);
  FrequencyBound best;
  for (int round = 0; round <= share_improvements; ++round) {
    const auto weight_at_nodes = sum_at_nodes(mesh, weight);
    FrequencyBound bound{weight, std::vector<double>(weight.size())};
    for (ElementIndex element = 0; element < mesh.elements.size(); ++element) {
      std::array<double, 3> mass{};
      for (int i = 0; i < 3; ++i) {
        const NodeIndex node = mesh.elements[element][i];
        mass[i] = density * area_at_nodes[node] / 3 * weight[element][i] / weight_at_nodes[node];
        bound.share[element][i] /= weight_at_nodes[node];
      }
      bound.squared[element] = element_frequency_squared(shapes[element], moduli, mass);
      for (double& value : weight[element]) value *= bound.squared[element];
    }
    if (round == 0 || largest(bound.squared) < largest(best.squared)) best = std::move(bound);
  }
  return best;
}

void update_frequencies(const Mesh& mesh, const NodeElements& elements, const Elasticity& moduli,
                        double density, const MeshChange& change, FrequencyBound& bound) {
  for (const MovedElement& moved : change.moved) {
    bound.share[moved.to] = bound.share[moved.from];
    bound.squared[moved.to] = bound.squared[moved.from];
  }
  bound.share.resize(mesh.elements.size());
  bound.squared.resize(mesh.elements.size());
  ChangedShares(mesh, elements, change).choose(moduli, density, bound);
}

StiffestElement stiffest_element(const Mesh& mesh, const FrequencyBound& bound) {
  const auto stiffest = std::max_element(bound.squared.begin(), bound.squared.end());
  const auto element = static_cast<ElementIndex>(stiffest - bound.squared.begin());
  return {*stiffest, element, centroid(mesh, element)};
}

}  // namespace fissura::structure
