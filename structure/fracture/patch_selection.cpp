// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/patch_selection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

namespace {

// Size of an element over target size.
constexpr double too_coarse = 2;
constexpr double coarse = 1.35;
constexpr double segments_ahead = 4;    // that a refinement looks ahead, in units of tip_size

Point point_ahead(const PatchPlace& place, double distance) {
  const double x = place.end[0] - place.begin[0], y = place.end[1] - place.begin[1], length = std::hypot(x, y);
  return {place.end[0] + distance * x / length, place.end[1] + distance * y / length};
}

class Selection {
 public:
  Selection(const Mesh& mesh, const NodeElements& node_elements, const MeshControls& controls, const PatchPlace& place)
      : mesh_(mesh),
        node_elements_(node_elements),
        place_(place),
        now_(controls, place.begin, place.end),
        ahead_(controls, place.begin, point_ahead(place, segments_ahead * controls.tip_size)),
        surroundings_(controls.tip_radius + segments_ahead * controls.tip_size) {}

  PatchChoice choose(CoarseElements coarse_elements) {
    visit();
    if (!refine_ || coarse_elements == CoarseElements::left) return {around_segment(), now_};
    std::unordered_set<ElementIndex> chosen;
    for (const ElementIndex element : around_segment()) chosen.insert(element);
    for (const ElementIndex element : seen_)
      if (size(element) > coarse * target(ahead_, element))
        for (const NodeIndex node : mesh_.elements[element])
          for (const ElementIndex neighbour : node_elements_.of(node)) chosen.insert(neighbour);
    std::vector<ElementIndex> elements(chosen.begin(), chosen.end());
    std::sort(elements.begin(), elements.end());
    return {std::move(elements), ahead_};
  }

 private:
  void visit() {
    std::unordered_set<ElementIndex> found;
    std::unordered_set<NodeIndex> reached{place_.tip};
    std::vector<NodeIndex> front{place_.tip};
    while (!front.empty()) {
      const NodeIndex node = front.back();
      front.pop_back();
      for (const ElementIndex element : node_elements_.of(node)) {
        if (!found.insert(element).second) continue;
        seen_.push_back(element);
        const double element_size = size(element);
        refine_ = refine_ || element_size > too_coarse * target(now_, element);
        if (gap(element) > surroundings_ && element_size <= coarse * target(ahead_, element)) continue;
        for (const NodeIndex corner : mesh_.elements[element])
          if (reached.insert(corner).second) front.push_back(corner);
      }
    }
    std::sort(seen_.begin(), seen_.end());
  }

  [[nodiscard]] std::vector<ElementIndex> around_segment() const {
    std::vector<ElementIndex> elements;
    for (const ElementIndex element : seen_) {
      const auto& corners = mesh_.elements[element];
      const bool at_tip = std::find(corners.begin(), corners.end(), place_.tip) != corners.end();
      if (at_tip || distance_to_segment(centroid(mesh_, element), place_.begin, place_.end) <= place_.radius)
        elements.push_back(element);
    }
    return elements;
  }

  // Edge of the equilateral triangle of the same area.
  [[nodiscard]] double size(ElementIndex element) const {
    return std::sqrt(4 / std::numbers::sqrt3 * triangle(mesh_, element).area);
  }

  [[nodiscard]] double gap(ElementIndex element) const {
    double least = distance_to_segment(centroid(mesh_, element), place_.begin, place_.end);
    for (const NodeIndex node : mesh_.elements[element])
      least = std::min(least, distance_to_segment(mesh_.position[node], place_.begin, place_.end));
    return least;
  }

  [[nodiscard]] double target(const TipSizeField& field, ElementIndex element) const {
    double least = field.size(centroid(mesh_, element));
    for (const NodeIndex node : mesh_.elements[element]) least = std::min(least, field.size(mesh_.position[node]));
    return least;
  }

  const Mesh& mesh_;
  const NodeElements& node_elements_;
  PatchPlace place_;
  TipSizeField now_, ahead_;
  double surroundings_;
  std::vector<ElementIndex> seen_;
  bool refine_ = false;
};

}  // namespace

PatchChoice choose_patch(const Mesh& mesh, const NodeElements& node_elements, const MeshControls& controls,
                         const PatchPlace& place, CoarseElements coarse_elements) {
  return Selection(mesh, node_elements, controls, place).choose(coarse_elements);
}

}  // namespace fissura::structure
