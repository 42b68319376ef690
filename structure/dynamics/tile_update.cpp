// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "common/errors.hpp"
#include "structure/dynamics/tile_building.hpp"
#include "structure/dynamics/triangle.hpp"

namespace fissura::structure {

namespace {

class TileUpdate {
 public:
  TileUpdate(const Mesh& mesh, const NodeElements& elements, const Body& body,
             const std::vector<NodeIndex>& joint_nodes, const MeshChange& change, Tiles& tiles)
      : mesh_(mesh),
        elements_(elements),
        body_(body),
        joint_nodes_(joint_nodes),
        change_(change),
        tiles_(tiles),
        stale_(tiles.tile.size(), 0) {}

  void run() {
    rename_moved();
    place_made();
    drop_freed_places();
    mark_tiles_of_nodes();
    cut_large_tiles();
    remove_empty_tiles();
    find_shared_nodes();
    TileBuilder builder(mesh_, body_, tiles_.shares);
    for (std::size_t t = 0; t < tiles_.tile.size(); ++t)
      if (stale_[t]) builder.build(tiles_.tile[t]);
    link_tiles(joint_nodes_, tiles_);
  }

 private:
  // Places stay where they are until all are known: `to` of a moved element is the index of a removed one. A
  // made element that was moved is placed as a made one.
  void rename_moved() {
    std::vector<ElementIndex*> place;
    for (const MovedElement& element : change_.moved) {
      if (std::binary_search(change_.made.begin(), change_.made.end(), element.to)) continue;
      moved_.push_back(element);
      moved_tile_.push_back(tiles_.tile_of_element[element.from]);
      place.push_back(&place_of(element.from));
    }
    for (const ElementIndex element : change_.removed) {
      stale_[tiles_.tile_of_element[element]] = 1;
      place_of(element) = freed;
    }
    for (std::size_t i = 0; i < place.size(); ++i) *place[i] = moved_[i].to;
    tiles_.tile_of_element.resize(mesh_.elements.size());
    for (const ElementIndex element : change_.made) tiles_.tile_of_element[element] = no_tile;
    for (std::size_t i = 0; i < moved_.size(); ++i) tiles_.tile_of_element[moved_[i].to] = moved_tile_[i];
  }

  ElementIndex& place_of(ElementIndex element) {
    auto& elements = tiles_.tile[tiles_.tile_of_element[element]].elements;
    const auto place = std::find(elements.begin(), elements.end(), element);
    ENSURE(place != elements.end());
    return *place;
  }

  // Elements that hang together go to one tile, so that few nodes are shared: the one with the most elements
  // around them.
  void place_made() {
    for (const ElementIndex first : change_.made) {
      if (tiles_.tile_of_element[first] != no_tile) continue;
      const std::vector<ElementIndex> patch = connected(first);
      const std::uint32_t home = home_of(patch);
      auto& elements = tiles_.tile[home].elements;
      auto place = elements.begin();
      auto next = patch.begin();
      for (; next != patch.end() && place != elements.end(); ++place)
        if (*place == freed) *place = *next++;
      elements.insert(elements.end(), next, patch.end());
      for (const ElementIndex element : patch) tiles_.tile_of_element[element] = home;
      stale_[home] = 1;
    }
  }

  // Made elements without a tile that can be reached from `first` through shared nodes, ascending.
  [[nodiscard]] std::vector<ElementIndex> connected(ElementIndex first) {
    std::vector<ElementIndex> found{first};
    tiles_.tile_of_element[first] = reached;
    for (std::size_t k = 0; k < found.size(); ++k)
      for (const NodeIndex node : mesh_.elements[found[k]])
        for (const ElementIndex element : elements_.of(node)) {
          if (tiles_.tile_of_element[element] != no_tile) continue;
          tiles_.tile_of_element[element] = reached;
          found.push_back(element);
        }
    std::sort(found.begin(), found.end());
    return found;
  }

  [[nodiscard]] std::uint32_t home_of(const std::vector<ElementIndex>& patch) const {
    std::vector<std::size_t> votes(tiles_.tile.size(), 0);
    for (const ElementIndex made : patch)
      for (const NodeIndex node : mesh_.elements[made])
        for (const ElementIndex element : elements_.of(node))
          if (tiles_.tile_of_element[element] < votes.size()) ++votes[tiles_.tile_of_element[element]];
    return static_cast<std::uint32_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }

  void drop_freed_places() {
    for (std::size_t t = 0; t < stale_.size(); ++t)
      if (stale_[t]) std::erase(tiles_.tile[t].elements, freed);
  }

  void mark_tiles_of_nodes() {
    for (const NodeIndex node : changed_nodes(change_)) {
      nodes_.push_back(node);
      for (const ElementIndex element : elements_.of(node)) stale_[tiles_.tile_of_element[element]] = 1;
    }
  }

  void cut_large_tiles() {
    for (std::size_t t = 0; t < tiles_.tile.size(); ++t)
      while (tiles_.tile[t].elements.size() > 2 * elements_per_tile) {
        for (const ElementIndex element : tiles_.tile[t].elements)
          nodes_.insert(nodes_.end(), mesh_.elements[element].begin(), mesh_.elements[element].end());
        cut(t);
      }
  }

  // Across its longer extent, with the elements of each half in their order.
  void cut(std::size_t t) {
    const std::vector<ElementIndex> whole = std::move(tiles_.tile[t].elements);
    std::array<double, 2> low = centroid(mesh_, whole.front()), high = low;
    for (const ElementIndex element : whole)
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], centroid(mesh_, element)[axis]);
        high[axis] = std::max(high[axis], centroid(mesh_, element)[axis]);
      }
    const int axis = high[0] - low[0] >= high[1] - low[1] ? 0 : 1;
    std::vector<std::pair<double, ElementIndex>> along;
    for (const ElementIndex element : whole) along.emplace_back(centroid(mesh_, element)[axis], element);
    const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::nth_element(along.begin(), middle, along.end());
    Tile second;
    tiles_.tile[t].elements.clear();
    for (const ElementIndex element : whole) {
      const bool first = std::pair(centroid(mesh_, element)[axis], element) < *middle;
      (first ? tiles_.tile[t] : second).elements.push_back(element);
      if (!first) tiles_.tile_of_element[element] = static_cast<std::uint32_t>(tiles_.tile.size());
    }
    tiles_.tile.push_back(std::move(second));
    stale_[t] = 1;
    stale_.push_back(1);
  }

  void remove_empty_tiles() {
    for (std::size_t t = tiles_.tile.size(); t-- > 0;) {
      if (!tiles_.tile[t].elements.empty()) continue;
      tiles_.tile[t] = std::move(tiles_.tile.back());
      stale_[t] = stale_.back();
      tiles_.tile.pop_back();
      stale_.pop_back();
      if (t == tiles_.tile.size()) continue;
      for (const ElementIndex element : tiles_.tile[t].elements)
        tiles_.tile_of_element[element] = static_cast<std::uint32_t>(t);
    }
  }

  void find_shared_nodes() {
    tiles_.shares.resize(mesh_.position.size(), 0);
    for (const NodeIndex node : nodes_) {
      const auto around = elements_.of(node);
      bool shared = !around.empty() && (is_held(body_, node) ||
                                        std::binary_search(joint_nodes_.begin(), joint_nodes_.end(), node));
      for (const ElementIndex element : around)
        shared |= tiles_.tile_of_element[element] != tiles_.tile_of_element[around.front()];
      tiles_.shares[node] = shared ? 1 : 0;
    }
  }

  static constexpr ElementIndex freed = 0xffffffffu;
  static constexpr std::uint32_t no_tile = 0xffffffffu, reached = 0xfffffffeu;

  const Mesh& mesh_;
  const NodeElements& elements_;
  const Body& body_;
  const std::vector<NodeIndex>& joint_nodes_;
  const MeshChange& change_;
  Tiles& tiles_;
  std::vector<std::uint8_t> stale_;
  std::vector<MovedElement> moved_;
  std::vector<std::uint32_t> moved_tile_;  // of each of moved_
  std::vector<NodeIndex> nodes_;
};

}  // namespace

void update_tiles(const Mesh& mesh, const NodeElements& elements, const Body& body,
                  const std::vector<NodeIndex>& joint_nodes, const MeshChange& change, Tiles& tiles) {
  TileUpdate(mesh, elements, body, joint_nodes, change, tiles).run();
}

}  // namespace fissura::structure
