// SPDX-License-Identifier: GPL-3.0-or-later
#include "structure/seismicity/merge_records.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "structure/seismicity/source_moment.hpp"

namespace fissura::structure {

namespace {

auto group_of(const SourceRecord& record) {
  return std::tuple(record.kind, record.failing, record.line, record.fracture);
}

double mean(std::span<const SourceRecord> records, double SourceRecord::*member) {
  double sum = 0, extent = 0;
  for (const SourceRecord& record : records) {
    sum += record.extent * record.*member;
    extent += record.extent;
  }
  return sum / extent;
}

SourceRecord joined(std::span<const SourceRecord> records) {
  SourceRecord all = records.front();
  if (records.size() == 1) return all;
  std::array<double, 2> place{}, normal{}, jump{};
  double time = 0, weight = 0, extent = 0;
  const bool weightless = std::all_of(records.begin(), records.end(),
                                      [](const SourceRecord& record) { return size_of(record.moment) == 0; });
  all.moment = all.pseudo_moment = {};
  for (const SourceRecord& record : records) {
    const double share = weightless ? 1 : size_of(record.moment);
    const double turn = record.normal[0] * all.normal[0] + record.normal[1] * all.normal[1] < 0 ? -1.0 : 1.0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      place[axis] += share * record.position[axis];
      normal[axis] += turn * record.extent * record.normal[axis];
      jump[axis] += turn * record.extent * record.jump[axis];
    }
    time += share * record.centroid_time;
    weight += share;
    extent += record.extent;
    all.moment = all.moment + record.moment;
    all.pseudo_moment = all.pseudo_moment + record.pseudo_moment;
    all.begin = std::min(all.begin, record.begin);
    all.end = std::max(all.end, record.end);
    all.element_size = std::max(all.element_size, record.element_size);
    all.peak_rate = std::max(all.peak_rate, record.peak_rate);
  }
  const double length = std::hypot(normal[0], normal[1]);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    all.position[axis] = place[axis] / weight;
    if (length > 0) all.normal[axis] = normal[axis] / length;
    all.jump[axis] = jump[axis] / extent;
  }
  all.centroid_time = std::clamp(time / weight, all.begin, all.end);
  all.extent = extent;
  for (double SourceRecord::*member :
       {&SourceRecord::measure, &SourceRecord::shear_before, &SourceRecord::shear_after,
        &SourceRecord::normal_before, &SourceRecord::normal_after, &SourceRecord::fluid_pressure})
    all.*member = mean(records, member);
  return all;
}

// Begins of runs of at most `together` records of one group.
std::vector<std::size_t> runs_of(const std::vector<SourceRecord>& records, std::size_t together) {
  std::vector<std::size_t> begin;
  for (std::size_t k = 0; k < records.size(); ++k)
    if (begin.empty() || k - begin.back() == together || group_of(records[k]) != group_of(records[k - 1]))
      begin.push_back(k);
  return begin;
}

}  // namespace

SourceRecords merged(std::vector<SourceRecord> records, std::size_t most) {
  const std::size_t count = records.size();
  if (count <= most) return {std::move(records), 0};
  std::sort(records.begin(), records.end(), [](const SourceRecord& a, const SourceRecord& b) {
    return std::tuple(group_of(a), a.entity, a.begin) < std::tuple(group_of(b), b.entity, b.begin);
  });
  std::size_t together = 2;
  std::vector<std::size_t> begin = runs_of(records, together);
  while (begin.size() > most && together < count) begin = runs_of(records, together *= 2);
  SourceRecords result{{}, count - begin.size()};
  for (std::size_t k = 0; k < begin.size(); ++k) {
    const std::size_t end = k + 1 < begin.size() ? begin[k + 1] : count;
    result.records.push_back(joined(std::span(records).subspan(begin[k], end - begin[k])));
  }
  std::sort(result.records.begin(), result.records.end(), comes_before);
  return result;
}

}  // namespace fissura::structure
