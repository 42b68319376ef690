// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/clustering.hpp"

#include <algorithm>
#include <tuple>

namespace fissura::coupler {

namespace {

bool earlier(const Source& a, const Source& b) {
  return comes_before(a, b);
}

}  // namespace

Clustering::Slot Clustering::root_of(Slot slot) {
  while (members_[slot].parent != slot) {
    members_[slot].parent = members_[members_[slot].parent].parent;
    slot = members_[slot].parent;
  }
  return slot;
}

void Clustering::unite(Slot a, Slot b) {
  a = root_of(a);
  b = root_of(b);
  if (a == b) return;
  if (members_[a].count < members_[b].count) std::swap(a, b);
  members_[b].parent = a;
  members_[a].count += members_[b].count;
  members_[a].greatest_reach = std::max(members_[a].greatest_reach, members_[b].greatest_reach);
  std::swap(members_[a].next, members_[b].next);
}

void Clustering::add(const Source& source) {
  Slot slot = static_cast<Slot>(members_.size());
  if (free_.empty()) {
    members_.emplace_back();
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  members_[slot] = {source, source.reach, slot, slot, 1};
  earliest_end_ = std::min(earliest_end_, source.reach);

  NeighbourGrid& grid = grids_[static_cast<std::size_t>(source.source_class)];
  const GridPoint point{source.position, source.cluster_radius, source.reach, slot};
  grid.for_each_neighbour(point, source.time, [&](Slot other) { unite(slot, other); });
  grid.insert(point, source.time);
}

std::vector<Source> Clustering::take(Slot root) {
  std::vector<Source> sources;
  sources.reserve(members_[root].count);
  Slot slot = root;
  do {
    sources.push_back(members_[slot].source);
    members_[slot].count = 0;
    free_.push_back(slot);
    slot = members_[slot].next;
  } while (slot != root);
  std::sort(sources.begin(), sources.end(), earlier);
  return sources;
}

std::vector<std::vector<Source>> Clustering::take_closed(double watermark) {
  if (earliest_end_ >= watermark) return {};
  struct Closed {
    double end;
    std::vector<Source> sources;
  };
  std::vector<Closed> closed;
  earliest_end_ = std::numeric_limits<double>::infinity();
  for (Slot slot = 0; slot < members_.size(); ++slot) {
    const Member& member = members_[slot];
    if (member.count == 0 || member.parent != slot) continue;
    const double end = member.greatest_reach;
    if (end < watermark)
      closed.push_back({end, take(slot)});
    else
      earliest_end_ = std::min(earliest_end_, end);
  }
  std::sort(closed.begin(), closed.end(), [](const Closed& a, const Closed& b) {
    return a.end != b.end ? a.end < b.end : earlier(a.sources.front(), b.sources.front());
  });
  std::vector<std::vector<Source>> clusters;
  clusters.reserve(closed.size());
  for (Closed& cluster : closed) clusters.push_back(std::move(cluster.sources));
  return clusters;
}

std::vector<Source> Clustering::open_sources() const {
  std::vector<Source> sources;
  for (const Member& member : members_)
    if (member.count > 0) sources.push_back(member.source);
  std::sort(sources.begin(), sources.end(), earlier);
  return sources;
}

}  // namespace fissura::coupler
