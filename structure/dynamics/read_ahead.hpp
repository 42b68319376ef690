// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "structure/dynamics/tiles.hpp"

namespace fissura::structure {

/// Asks the memory for the tile a thread will probably work on next, piece by piece while the present one is
/// computed: on meshes that outgrow the cache the loop then waits less for memory. Changes no result.
class ReadAhead {
 public:
  /// `next` is null at the end of the tiles; displacement and velocity are interleaved x, y per node of the
  /// mesh.
  ReadAhead(const Tile* next, const double* displacement, const double* velocity)
      : next_(next), displacement_(displacement), velocity_(velocity) {
    if (next_ != nullptr) nodes_per_256_groups_ = 256 * next_->nodes.size() / next_->groups.size();
  }

  /// Asks for the group in this place of the next tile and for its share of the nodes.
  /// Always inlined: g++ 12 drops calls of functions that do nothing but prefetch.
  [[gnu::always_inline]] void fetch(std::size_t group) const {
    if (next_ == nullptr || group >= next_->groups.size()) return;
    fetch_bytes<sizeof(ElementGroup)>(&next_->groups[group]);
    const std::size_t node = group * nodes_per_256_groups_ / 256;
    const std::size_t dof = 2 * std::size_t{next_->nodes[node]};
    fetch_bytes<1>(&next_->nodes[node]);
    fetch_bytes<1>(&next_->position[node]);
    fetch_bytes<1>(displacement_ + dof);
    fetch_bytes<1>(velocity_ + dof);
    if (node < next_->interior.size())
      fetch_bytes<group_width / 2 * sizeof(InteriorNode)>(&next_->interior[node]);
  }

 private:
  template <std::size_t bytes>
  [[gnu::always_inline]] static void fetch_bytes(const void* first) {
    constexpr std::size_t cache_line = 64;
    for (std::size_t offset = 0; offset < bytes; offset += cache_line)
      __builtin_prefetch(static_cast<const char*>(first) + offset, 0, 2);
  }

  const Tile* next_;
  const double* displacement_;
  const double* velocity_;
  std::size_t nodes_per_256_groups_ = 0;
};

}  // namespace fissura::structure
