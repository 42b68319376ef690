// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/mesh/node_elements.hpp"

#include <algorithm>

namespace fissura::structure {
namespace {

void sort_without_repeats(std::vector<std::uint32_t>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

bool has_corner(const Mesh& mesh, ElementIndex element, NodeIndex node) {
  const auto& corners = mesh.elements[element];
  return std::find(corners.begin(), corners.end(), node) != corners.end();
}

}  // namespace

NodeElements::NodeElements(const Mesh& mesh) : rows_(mesh.position.size()) {
  for (const auto& corners : mesh.elements)
    for (const NodeIndex node : corners) ++rows_[node].room;
  for (Row& row : rows_) {
    row.first = static_cast<std::uint32_t>(used_);
    used_ += row.room;
  }
  elements_.resize(used_);
  for (ElementIndex element = 0; element < mesh.elements.size(); ++element)
    for (const NodeIndex node : mesh.elements[element]) {
      Row& row = rows_[node];
      elements_[row.first + row.count++] = element;
    }
}

std::span<const ElementIndex> NodeElements::of(NodeIndex node) const {
  const Row& row = rows_[node];
  return {elements_.data() + row.first, row.count};
}

void NodeElements::follow(const Mesh& mesh, const MeshChange& change) {
  rows_.resize(mesh.position.size());
  std::vector<std::pair<NodeIndex, ElementIndex>> arrived;
  for (const ElementIndex element : changed_elements(change))
    for (const NodeIndex node : mesh.elements[element]) arrived.emplace_back(node, element);
  std::sort(arrived.begin(), arrived.end());

  std::vector<NodeIndex> affected = changed_nodes(change);
  for (const MovedElement& element : change.moved)
    affected.insert(affected.end(), mesh.elements[element.to].begin(), mesh.elements[element.to].end());
  sort_without_repeats(affected);

  std::vector<ElementIndex> around;
  auto next = arrived.begin();
  for (const NodeIndex node : affected) {
    around.clear();
    for (const ElementIndex element : of(node))
      if (element < mesh.elements.size() && has_corner(mesh, element, node)) around.push_back(element);
    for (; next != arrived.end() && next->first <= node; ++next)
      if (next->first == node) around.push_back(next->second);
    sort_without_repeats(around);
    replace(node, around);
  }
  if (elements_.size() > 2 * used_) close_gaps();
}

void NodeElements::replace(NodeIndex node, std::span<const ElementIndex> elements) {
  Row& row = rows_[node];
  const auto count = static_cast<std::uint32_t>(elements.size());
  used_ = used_ - row.count + count;
  if (count > row.room) {
    row.first = static_cast<std::uint32_t>(elements_.size());
    row.room = count;
    elements_.resize(elements_.size() + count);
  }
  row.count = count;
  std::copy(elements.begin(), elements.end(), elements_.begin() + row.first);
}

void NodeElements::close_gaps() {
  std::vector<ElementIndex> dense;
  dense.reserve(used_);
  for (Row& row : rows_) {
    const auto begin = elements_.begin() + row.first;
    row.first = static_cast<std::uint32_t>(dense.size());
    row.room = row.count;
    dense.insert(dense.end(), begin, begin + row.count);
  }
  elements_ = std::move(dense);
}

std::vector<NodeIndex> changed_nodes(const MeshChange& change) {
  std::vector<NodeIndex> nodes = change.touched_nodes;
  nodes.insert(nodes.end(), change.new_nodes.begin(), change.new_nodes.end());
  nodes.insert(nodes.end(), change.unused_nodes.begin(), change.unused_nodes.end());
  sort_without_repeats(nodes);
  return nodes;
}

std::vector<ElementIndex> changed_elements(const MeshChange& change) {
  std::vector<ElementIndex> elements = change.made;
  elements.insert(elements.end(), change.rewired.begin(), change.rewired.end());
  for (const MovedElement& element : change.moved) elements.push_back(element.to);
  sort_without_repeats(elements);
  return elements;
}

}  // namespace fissura::structure
