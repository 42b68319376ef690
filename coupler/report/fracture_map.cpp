// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/report/fracture_map.hpp"

#include <map>

#include "common/fracture_network/fracture_network.hpp"
#include "coupler/report/drawn_numbers.hpp"
#include "coupler/report/thinning.hpp"

namespace fissura::coupler {

namespace {

using nlohmann::json;

/// Nodes and segments of all revisions, each once, numbered as they come.
class Pool {
 public:
  /// @returns the numbers of the nodes of this revision, in its order
  std::vector<std::size_t> add(FieldReports& reports, std::uint64_t revision, std::size_t report) {
    const std::vector<double> id = reports.of_network(revision, "id"),
                              position = reports.of_network(revision, "position");
    std::vector<std::size_t> numbers;
    for (std::size_t node = 0; node < id.size(); ++node) {
      const auto [found, is_new] = number_of_node_.try_emplace(id[node], x_.size());
      if (is_new) {
        x_.push_back(for_drawing(position[2 * node]));
        y_.push_back(for_drawing(position[2 * node + 1]));
      }
      numbers.push_back(found->second);
    }
    const std::vector<double> segment_id = reports.of_network(revision, "segment_id");
    const std::vector<double> ends = reports.of_network(revision, "segments"),
                              kind = reports.of_network(revision, "segment_kind");
    for (std::size_t segment = 0; segment < segment_id.size(); ++segment) {
      if (!seen_.emplace(segment_id[segment], report).second) continue;
      const auto first = static_cast<std::size_t>(ends[2 * segment]),
                 second = static_cast<std::size_t>(ends[2 * segment + 1]);
      segments_.push_back({numbers[first], numbers[second], report});
      kinds_.push_back(static_cast<int>(kind[segment]));
    }
    return numbers;
  }

  [[nodiscard]] std::size_t nodes() const { return x_.size(); }
  [[nodiscard]] json node_list() const { return {{"x", x_}, {"y", y_}}; }
  [[nodiscard]] const json& segment_list() const { return segments_; }
  [[nodiscard]] const json& kind_list() const { return kinds_; }

 private:
  std::map<double, std::size_t> number_of_node_, seen_;
  std::vector<double> x_, y_;
  json segments_ = json::array(), kinds_ = json::array();
};

json by_node(const std::vector<double>& values, const std::vector<std::size_t>& numbers, std::size_t nodes) {
  json list(nodes, json());
  for (std::size_t node = 0; node < numbers.size(); ++node) list[numbers[node]] = for_drawing(values[node]);
  return list;
}

}  // namespace

json fracture_map(FieldReports& reports, std::size_t most_reports) {
  Pool pool;
  json shown = json::array();
  for (const std::size_t index : evenly_spread(reports.all().size(), most_reports)) {
    const FieldReport& report = reports.all()[index];
    const std::vector<std::size_t> numbers = pool.add(reports, report.revision, shown.size());
    json entry{{"time", report.time}, {"revision", report.revision}};
    for (const char* field : {"aperture", "pressure"}) {
      const std::string array = std::string("network/") + field;
      const bool is_there = !numbers.empty() && reports.has(report, array);
      entry[field] =
          is_there ? by_node(reports.of_report(report, array), numbers, pool.nodes()) : json::array();
    }
    shown.push_back(std::move(entry));
  }
  return {{"nodes", pool.node_list()},
          {"segments", pool.segment_list()},
          {"kinds", pool.kind_list()},
          {"reports", shown}};
}

std::vector<double> hydraulic_nodes(FieldReports& reports, std::uint64_t revision) {
  const std::vector<double> position = reports.of_network(revision, "position"),
                            ends = reports.of_network(revision, "segments"),
                            kind = reports.of_network(revision, "segment_kind");
  std::vector<double> nodes;
  for (std::size_t end = 0; end < ends.size(); ++end) {
    if (kind[end / 2] != static_cast<double>(SegmentKind::hydraulic)) continue;
    const auto node = static_cast<std::size_t>(ends[end]);
    nodes.insert(nodes.end(), {position[2 * node], position[2 * node + 1]});
  }
  return nodes;
}

}  // namespace fissura::coupler
