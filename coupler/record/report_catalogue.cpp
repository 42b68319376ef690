// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/report_catalogue.hpp"

#include <algorithm>

namespace fissura::coupler {

namespace {

/// They are listed one by one in the files for viewers.
constexpr std::uint64_t most_points = 1 << 22;

void put(ByteWriter& archive, const StoredArray& array) {
  for (const std::string* text : {&array.name, &array.dtype, &array.unit, &array.location})
    archive.put(*text);
  archive.put(array.shape);
}

void get(ByteReader& archive, StoredArray& array) {
  for (std::string* text : {&array.name, &array.dtype, &array.unit, &array.location}) archive.get(*text);
  archive.get(array.shape);
  ByteReader::require(!array.shape.empty());
}

void get_table(ByteReader& archive, StoredArray& array, std::uint64_t columns) {
  get(archive, array);
  ByteReader::require(array.shape.size() == 2 && array.shape[1] == columns);
}

void put(ByteWriter& archive, const std::vector<StoredArray>& arrays) {
  archive.put(static_cast<std::uint64_t>(arrays.size()));
  for (const StoredArray& array : arrays) put(archive, array);
}

std::uint64_t get_count(ByteReader& archive) {
  std::uint64_t count = 0;
  archive.get(count);
  return count;
}

void get(ByteReader& archive, std::vector<StoredArray>& arrays) {
  arrays.clear();
  for (std::uint64_t left = get_count(archive); left > 0; --left) get(archive, arrays.emplace_back());
}

}  // namespace

void put(ByteWriter& archive, const ReportCatalogue& catalogue) {
  archive.put(static_cast<std::uint64_t>(catalogue.meshes.size()));
  for (const auto& [geometry, mesh] : catalogue.meshes) {
    archive.put(geometry);
    put(archive, mesh.position);
    put(archive, mesh.elements);
  }
  archive.put(static_cast<std::uint64_t>(catalogue.networks.size()));
  for (const auto& [revision, network] : catalogue.networks) {
    archive.put(revision);
    put(archive, network.position);
    put(archive, network.segments);
  }
  archive.put(static_cast<std::uint64_t>(catalogue.reports.size()));
  for (const StoredReport& report : catalogue.reports) {
    archive.put(report.number);
    archive.put(report.time);
    archive.put(report.geometry);
    archive.put(report.revision);
    for (const auto* arrays : {&report.mesh_nodes, &report.mesh_elements, &report.network_nodes,
                               &report.network_segments, &report.joints})
      put(archive, *arrays);
  }
  archive.put(static_cast<std::uint64_t>(catalogue.sources.size()));
  for (const StoredSources& sources : catalogue.sources) {
    archive.put(sources.number);
    archive.put(sources.time);
    put(archive, sources.arrays);
  }
}

ReportCatalogue get_catalogue(ByteReader& archive) {
  ReportCatalogue catalogue;
  for (std::uint64_t left = get_count(archive); left > 0; --left) {
    StoredMesh& mesh = catalogue.meshes[get_count(archive)];
    get_table(archive, mesh.position, 2);
    get_table(archive, mesh.elements, 3);
  }
  for (std::uint64_t left = get_count(archive); left > 0; --left) {
    StoredNetwork& network = catalogue.networks[get_count(archive)];
    get_table(archive, network.position, 2);
    get_table(archive, network.segments, 2);
    ByteReader::require(network.position.shape[0] <= most_points);
  }
  for (std::uint64_t left = get_count(archive); left > 0; --left) {
    StoredReport& report = catalogue.reports.emplace_back();
    archive.get(report.number);
    archive.get(report.time);
    archive.get(report.geometry);
    archive.get(report.revision);
    for (auto* arrays : {&report.mesh_nodes, &report.mesh_elements, &report.network_nodes,
                         &report.network_segments, &report.joints})
      get(archive, *arrays);
    for (const StoredArray& array : report.joints) ByteReader::require(array.shape[0] <= most_points);
  }
  for (std::uint64_t left = get_count(archive); left > 0; --left) {
    StoredSources& sources = catalogue.sources.emplace_back();
    archive.get(sources.number);
    archive.get(sources.time);
    get(archive, sources.arrays);
  }
  return catalogue;
}

void require_meshes_and_networks(const std::vector<StoredReport>& reports,
                                 std::initializer_list<const ReportCatalogue*> catalogues) {
  const auto in_one = [&](auto holds) { return std::any_of(catalogues.begin(), catalogues.end(), holds); };
  for (const StoredReport& report : reports) {
    ByteReader::require(
        in_one([&](const auto* catalogue) { return catalogue->meshes.contains(report.geometry); }));
    ByteReader::require(
        in_one([&](const auto* catalogue) { return catalogue->networks.contains(report.revision); }));
  }
}

}  // namespace fissura::coupler
