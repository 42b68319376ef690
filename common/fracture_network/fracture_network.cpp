// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/fracture_network/fracture_network.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <span>

#include "common/errors.hpp"
#include "common/hash.hpp"

namespace fissura {

namespace {

static_assert(std::endian::native == std::endian::little, "the wire format is little-endian");

void require_length(double length, const char* what, std::uint64_t id) {
  if (!(std::isfinite(length) && length > 0))
    throw ProtocolError(fmt::format("{} of {} must be positive, found {}", what, id, length));
}

class HashedNumbers {
 public:
  void add(std::uint64_t number) { append(&number); }
  void add(double number) { append(&number); }
  [[nodiscard]] std::string sha256() const { return fissura::sha256(bytes_); }

 private:
  template <typename T>
  void append(const T* number) {
    static_assert(sizeof(T) == 8);
    const auto* first = reinterpret_cast<const std::byte*>(number);
    bytes_.insert(bytes_.end(), first, first + sizeof(T));
  }
  std::vector<std::byte> bytes_;
};

}  // namespace

void FractureNetwork::apply(const Insertion& insertion) {
  const std::uint64_t expected = revision_ ? *revision_ + 1 : 0;
  if (insertion.revision != expected)
    throw ProtocolError(
        fmt::format("insertion makes revision {}, expected revision {}", insertion.revision, expected));

  FractureNetwork next = *this;
  next.revision_ = insertion.revision;
  for (const NetworkNode& node : insertion.updated_nodes) {
    require_length(node.lumped_length, "lumped length of node", node.id);
    next.nodes_[next.index_of(node.id)] = node;
  }
  for (const NetworkNode& node : insertion.new_nodes) {
    require_length(node.lumped_length, "lumped length of node", node.id);
    if (!next.node_index_.emplace(node.id, next.nodes_.size()).second)
      throw ProtocolError(fmt::format("node {} exists already", node.id));
    next.nodes_.push_back(node);
  }
  for (const SegmentId id : insertion.removed_segments) {
    const auto known = next.known_segments_.find(id);
    if (known == next.known_segments_.end() || !known->second)
      throw ProtocolError(fmt::format("segment {} to be removed does not exist", id));
    known->second = false;
    std::erase_if(next.segments_, [id](const NetworkSegment& segment) { return segment.id == id; });
  }
  for (const NetworkSegment& segment : insertion.new_segments) {
    require_length(segment.length, "length of segment", segment.id);
    (void)next.index_of(segment.node_a);
    (void)next.index_of(segment.node_b);
    if (!next.known_segments_.emplace(segment.id, true).second)
      throw ProtocolError(fmt::format("segment {} exists already", segment.id));
    next.segments_.push_back(segment);
  }
  for (const NodeParent& pair : insertion.parents) {
    (void)next.index_of(pair.node);
    (void)next.index_of(pair.parent);
  }
  for (const PerforationNode& perforation : insertion.new_perforations) {
    (void)next.index_of(perforation.node);
    next.perforations_.push_back(perforation);
  }
  *this = std::move(next);
}

std::uint64_t FractureNetwork::revision() const {
  ENSURE(revision_.has_value());
  return *revision_;
}

std::size_t FractureNetwork::index_of(NodeId id) const {
  const auto found = node_index_.find(id);
  if (found == node_index_.end()) throw ProtocolError(fmt::format("node {} does not exist", id));
  return found->second;
}

std::vector<std::size_t> FractureNetwork::segments_at(std::size_t index) const {
  const NodeId id = nodes_.at(index).id;
  std::vector<std::size_t> found;
  for (std::size_t s = 0; s < segments_.size(); ++s)
    if (segments_[s].node_a == id || segments_[s].node_b == id) found.push_back(s);
  return found;
}

std::string FractureNetwork::topology_hash() const {
  HashedNumbers numbers;
  numbers.add(revision());
  for (const NetworkNode& node : nodes_) {
    numbers.add(node.id);
    numbers.add(node.x);
    numbers.add(node.y);
    numbers.add(node.lumped_length);
    numbers.add(node.fracture);
    numbers.add(static_cast<std::uint64_t>(node.role));
  }
  for (const NetworkSegment& segment : segments_) {
    numbers.add(segment.id);
    numbers.add(segment.node_a);
    numbers.add(segment.node_b);
    numbers.add(segment.length);
  }
  return numbers.sha256();
}

}  // namespace fissura
