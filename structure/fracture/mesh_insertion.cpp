// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/fracture/mesh_insertion.hpp"

#include <algorithm>
#include <set>

namespace fissura::structure {

namespace {

template <class Index>
std::vector<Index> ascending(const std::set<Index>& indices) {
  return {indices.begin(), indices.end()};
}

class MeshInserter {
 public:
  MeshInserter(const GrowthPlan& plan, Mesh& mesh)
      : plan_(plan), mesh_(mesh), edges_before_(static_cast<EdgeIndex>(mesh.edges.size())) {
    change().elements_before = mesh.elements.size();
    change().nodes_before = mesh.position.size();
  }

  MeshInsertion insert() {
    list_what_goes();
    place_nodes();
    rewire();
    place_elements();
    list_touched_nodes();
    mesh_.lines.insert(mesh_.lines.end(), plan_.new_lines.begin(), plan_.new_lines.end());
    for (std::size_t k = 0; k < plan_.patches.size(); ++k) extend_fractures(k);
    return std::move(result_);
  }

 private:
  MeshChange& change() { return result_.change; }

  void list_what_goes() {
    std::set<ElementIndex> removed;
    std::set<NodeIndex> unused;
    for (const PatchPlan& patch : plan_.patches) {
      removed.insert(patch.removed.begin(), patch.removed.end());
      unused.insert(patch.unused.begin(), patch.unused.end());
    }
    change().removed = ascending(removed);
    for (const ElementIndex element : change().removed)
      touched_.insert(mesh_.elements[element].begin(), mesh_.elements[element].end());
    free_ = mesh_.unused_nodes;
    free_.insert(free_.end(), unused.begin(), unused.end());
    std::sort(free_.begin(), free_.end());
    unused_ = std::move(unused);
  }

  void place_nodes() {
    std::size_t next_free = 0;
    for (const PatchPlan& patch : plan_.patches) {
      auto& node_of = result_.node.emplace_back();
      for (const PlannedNode& planned : patch.nodes) {
        NodeIndex node = static_cast<NodeIndex>(mesh_.position.size());
        if (next_free < free_.size())
          node = free_[next_free++];
        else
          mesh_.position.emplace_back();
        mesh_.position[node] = planned.position;
        node_of.push_back(node);
        if (planned.origin == PlannedNode::Origin::copy) copy_sides(planned.source, node);
      }
    }
    free_.erase(free_.begin(), free_.begin() + static_cast<std::ptrdiff_t>(next_free));
    mesh_.unused_nodes = free_;
    for (const auto& nodes : result_.node) change().new_nodes.insert(change().new_nodes.end(), nodes.begin(), nodes.end());
    std::sort(change().new_nodes.begin(), change().new_nodes.end());
    for (const NodeIndex node : unused_)
      if (std::binary_search(free_.begin(), free_.end(), node)) change().unused_nodes.push_back(node);
  }

  void copy_sides(NodeIndex source, NodeIndex copy) {
    for (auto& side : mesh_.side_nodes)
      if (std::find(side.begin(), side.end(), source) != side.end()) side.push_back(copy);
  }

  void rewire() {
    std::set<ElementIndex> rewired;
    for (std::size_t k = 0; k < plan_.patches.size(); ++k)
      for (const Rewiring& rewiring : plan_.patches[k].rewired) {
        mesh_.elements[rewiring.element][static_cast<std::size_t>(rewiring.corner)] = result_.index_of(k, rewiring.node);
        rewired.insert(rewiring.element);
      }
    change().rewired = ascending(rewired);
  }

  void place_elements() {
    std::size_t next = 0;
    const auto& removed = change().removed;
    for (std::size_t k = 0; k < plan_.patches.size(); ++k)
      for (const auto& planned : plan_.patches[k].made) {
        const std::array<NodeIndex, 3> corners{result_.index_of(k, planned[0]), result_.index_of(k, planned[1]),
                                               result_.index_of(k, planned[2])};
        if (next < removed.size()) {
          mesh_.elements[removed[next]] = corners;
          change().made.push_back(removed[next++]);
        } else {
          change().made.push_back(static_cast<ElementIndex>(mesh_.elements.size()));
          mesh_.elements.push_back(corners);
        }
      }
    std::sort(change().made.begin(), change().made.end());
    fill_places({removed.begin() + static_cast<std::ptrdiff_t>(next), removed.end()});
  }

  void fill_places(std::vector<ElementIndex> empty) {
    while (!empty.empty()) {
      const auto last = static_cast<ElementIndex>(mesh_.elements.size() - 1);
      if (empty.back() == last) {
        empty.pop_back();
      } else {
        mesh_.elements[empty.front()] = mesh_.elements[last];
        change().moved.push_back({last, empty.front()});
        rename(last, empty.front());
        empty.erase(empty.begin());
      }
      mesh_.elements.pop_back();
    }
  }

  void rename(ElementIndex from, ElementIndex to) {
    for (auto* list : {&change().made, &change().rewired})
      if (const auto found = std::find(list->begin(), list->end(), from); found != list->end()) {
        *found = to;
        std::sort(list->begin(), list->end());
      }
  }

  void list_touched_nodes() {
    for (const auto* list : {&change().made, &change().rewired})
      for (const ElementIndex element : *list)
        touched_.insert(mesh_.elements[element].begin(), mesh_.elements[element].end());
    for (const NodeIndex node : touched_)
      if (!std::binary_search(free_.begin(), free_.end(), node)) change().touched_nodes.push_back(node);
  }

  void extend_fractures(std::size_t k) {
    const PatchPlan& patch = plan_.patches[k];
    for (FractureVertex vertex : patch.new_vertices) {
      vertex.node = result_.index_of(k, vertex.node);
      change().new_vertices.push_back(static_cast<VertexIndex>(mesh_.vertices.size()));
      mesh_.vertices.push_back(vertex);
    }
    const auto first_new_edge = static_cast<EdgeIndex>(mesh_.edges.size());
    for (const FractureEdge& edge : patch.new_edges) add_edge(mesh_, edge);
    for (const PlannedUnit& planned : patch.units) {
      const ContactUnit unit{result_.index_of(k, planned.minus), result_.index_of(k, planned.plus), planned.face,
                             planned.length, planned.vertex, planned.line};
      const UnitIndex index = planned.same ? *planned.same : static_cast<UnitIndex>(mesh_.units.size());
      for (const PlannedEdgeEnd& at : planned.edge_ends) {
        const EdgeIndex edge = at.edge < edges_before_ ? at.edge : first_new_edge + (at.edge - edges_before_);
        mesh_.edges[edge].unit[static_cast<std::size_t>(at.end)] = index;
      }
      if (planned.same) {
        mesh_.units[index] = unit;
        change().changed_units.push_back(*planned.same);
      } else {
        change().new_units.push_back(index);
        mesh_.vertices[planned.vertex].units.push_back(index);
        mesh_.units.push_back(unit);
      }
    }
    std::sort(change().changed_units.begin(), change().changed_units.end());
  }

  const GrowthPlan& plan_;
  Mesh& mesh_;
  EdgeIndex edges_before_;
  MeshInsertion result_;
  std::vector<NodeIndex> free_;
  std::set<NodeIndex> unused_, touched_;
};

}  // namespace

MeshInsertion insert_into_mesh(const GrowthPlan& plan, Mesh& mesh) { return MeshInserter(plan, mesh).insert(); }

}  // namespace fissura::structure
