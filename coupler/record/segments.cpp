// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/segments.hpp"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>

#include "common/errors.hpp"
#include "common/faults/fault_point.hpp"
#include "common/hash.hpp"
#include "coupler/record/field_arrays.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/sealed_line.hpp"
#include "coupler/record/segment_files.hpp"

namespace fissura::coupler {

namespace {

constexpr const char *index_name = "index.jsonl", *index_place = "segments/index.jsonl";

Message node_field_arrays(const std::vector<NodeField>& node_fields) {
  Message arrays(MessageType::fields);
  for (const NodeField& field : node_fields) arrays.add(field.name, field.unit, field.values);
  return arrays;
}

void check_elements(const Array& elements, std::uint64_t nodes) {
  std::vector<std::uint64_t> indices(elements.bytes.size() / sizeof(std::uint64_t));
  std::memcpy(indices.data(), elements.bytes.data(), elements.bytes.size());
  for (const std::uint64_t index : indices)
    if (index >= nodes)
      throw ProtocolError(
          fmt::format("the elements of the structure name node {}; the mesh has {} nodes", index, nodes));
}

bool is_vector_of_the_plane(const Array& array) {
  return array.dtype == "float64" && array.shape.size() == 2 && array.shape[1] == 2;
}

}  // namespace

Segments::Segments(const std::filesystem::path& run_directory, int reports_per_segment)
    : run_directory_(run_directory), reports_per_segment_(static_cast<std::uint64_t>(reports_per_segment)) {
  ENSURE(reports_per_segment > 0);
}

bool Segments::add(double time, const Message& all_structure_fields, const Message& network_fields,
                   const FractureNetwork& network, const std::vector<NodeField>& node_fields) {
  Message structure_fields = all_structure_fields;
  const std::vector<Array> joints = take_joint_arrays(structure_fields, "structure");
  StoredReport report;
  report.number = reports_ + 1;
  report.time = time;
  report.geometry = structure_fields.value<std::uint64_t>("geometry");
  report.revision = network.revision();

  const auto [mesh_nodes, mesh_elements] = mesh_extent(report.geometry, structure_fields);
  const Message coupler_fields = node_field_arrays(node_fields);
  const std::uint64_t nodes = network.nodes().size(), segments = network.segments().size();
  const SortedFields on_mesh =
      sort_fields(structure_fields, "structure", mesh_nodes, mesh_elements, {"position", "elements"});
  const SortedFields of_coupler = sort_fields(coupler_fields, "coupler", nodes, segments, {});
  const SortedFields of_network = sort_fields(network_fields, "network", nodes, segments, {});

  write_mesh(report.geometry, structure_fields);
  write_network(network);

  const std::string group = fmt::format("/reports/{:06}", report.number);
  const auto write_all = [&](const std::vector<const Array*>& arrays, const std::string& name,
                             const std::string& prefix, std::vector<StoredArray>& stored) {
    for (const Array* array : arrays)
      stored.push_back(write(fmt::format("{}/{}/{}", group, name, array->name), prefix + array->name,
                             is_vector_of_the_plane(*array) ? with_zero_third_column(*array) : *array));
  };
  journal_.create_group(group);
  write_all(on_mesh.nodes, "structure", "", report.mesh_nodes);
  write_all(on_mesh.cells, "structure", "", report.mesh_elements);
  write_all(of_coupler.nodes, "fractures", "", report.network_nodes);
  write_all(of_coupler.cells, "fractures", "", report.network_segments);
  write_all(of_network.nodes, "network", "network_", report.network_nodes);
  write_all(of_network.cells, "network", "network_", report.network_segments);
  for (const Array& array : joints) {
    const bool is_direction = is_vector_of_the_plane(array) && array.name != "position";
    report.joints.push_back(write(group + "/joints/" + array.name, array.name,
                                  is_direction ? with_zero_third_column(array) : array));
  }
  journal_.write_attribute(group, "time", time);
  journal_.write_attribute(group, "geometry", report.geometry);
  journal_.write_attribute(group, "revision", report.revision);
  open_.reports.push_back(std::move(report));
  ++reports_;
  const bool is_full = open_.reports.size() >= reports_per_segment_ || journal_.bytes() >= largest_segment;
  return is_full && close();
}

void Segments::add_sources(double time, const std::vector<SourceRecord>& records) {
  if (records.empty()) return;
  StoredSources stored{sources_ + 1, time, {}};
  const std::string group = fmt::format("/sources/{:06}", stored.number);
  journal_.create_group(group);
  for (const Array& array : arrays_of(records))
    stored.arrays.push_back(write(group + "/" + array.name, array.name, array));
  journal_.write_attribute(group, "time", time);
  open_.sources.push_back(std::move(stored));
  ++sources_;
}

bool Segments::close() {
  if (journal_.empty()) return false;
  try {
    write_segment();
  } catch (const StorageError&) {
    // The space is better used for the report of the failure.
    std::error_code ignored;
    std::filesystem::remove(folder() / (segment_name(segment_) + ".part"), ignored);
    journal_ = {};
    open_ = {};
    throw;
  }
  journal_ = {};
  closed_.meshes.merge(open_.meshes);
  closed_.networks.merge(open_.networks);
  closed_.sources.insert(closed_.sources.end(), open_.sources.begin(), open_.sources.end());
  closed_.reports.insert(closed_.reports.end(), open_.reports.begin(), open_.reports.end());
  open_ = {};
  ++segment_;
  return true;
}

void Segments::write_segment() {
  std::error_code failure;
  std::filesystem::create_directory(folder(), failure);
  if (failure) throw StorageError(fmt::format("cannot create {}: {}", folder().string(), failure.message()));
  if (!index_) {
    index_.emplace(folder() / index_name);
    sync_to_disk(run_directory_);
  }
  if (!std::filesystem::exists(folder() / index_name, failure))
    throw StorageError(
        fmt::format("{} was removed while the run wrote it", (folder() / index_name).string()));
  const std::filesystem::path file = folder() / segment_name(segment_), part = file.string() + ".part";
  Hdf5File output = Hdf5File::create(part);
  journal_.write_to(output);
  fault_point(FaultPhase::segment);
  output.close();
  journal_.compare_with(Hdf5File::open(part));

  const std::string hash = sha256_of_file(part);
  const std::uintmax_t size = std::filesystem::file_size(part, failure);
  if (failure) throw StorageError(fmt::format("cannot read {}: {}", part.string(), failure.message()));
  fault_point(FaultPhase::segment);
  publish(part, file);
  fault_point(FaultPhase::segment);
  append_to_index(hash, size);
}

void Segments::append_to_index(const std::string& file_hash, std::uintmax_t file_size) {
  nlohmann::ordered_json line;
  line["file"] = segment_name(segment_);
  line["sha256"] = file_hash;
  line["bytes"] = file_size;
  line["reports"] = {reports_ - open_.reports.size() + 1, reports_};
  line["time"] = nlohmann::ordered_json::array();
  line["revision"] = nlohmann::ordered_json::array();
  if (!open_.reports.empty()) {
    const StoredReport &first = open_.reports.front(), &last = open_.reports.back();
    line["time"] = {first.time, last.time};
    line["revision"] = {first.revision, last.revision};
  }
  line["sources"] = {sources_ - open_.sources.size() + 1, sources_};
  line["meshes"] = nlohmann::ordered_json::array();
  for (const auto& [geometry, mesh] : open_.meshes) line["meshes"].push_back(geometry);
  line["networks"] = nlohmann::ordered_json::array();
  for (const auto& [revision, network] : open_.networks) line["networks"].push_back(revision);
  index_->append(sealed_line(line) + "\n");
  index_->sync();
}

void Segments::save(TableMarks& marks, ByteWriter& archive) const {
  if (index_) marks[index_place] = index_->mark();
  archive.put(segment_);
  archive.put(reports_);
  archive.put(sources_);
  journal_.save(archive);
  put(archive, closed_);
  put(archive, open_);
}

void Segments::resume(const TableMarks& marks, ByteReader& archive) {
  archive.get(segment_);
  archive.get(reports_);
  archive.get(sources_);
  journal_.restore(archive);
  closed_ = get_catalogue(archive);
  open_ = get_catalogue(archive);
  require_meshes_and_networks(closed_.reports, {&closed_});
  require_meshes_and_networks(open_.reports, {&closed_, &open_});
  index_ = at_mark(run_directory_, index_place, marks);
  supersede_segments_after(segment_ - 1, folder());
}

const StoredMesh* Segments::find_mesh(std::uint64_t geometry) const {
  for (const ReportCatalogue* catalogue : {&closed_, &open_})
    if (const auto found = catalogue->meshes.find(geometry); found != catalogue->meshes.end())
      return &found->second;
  return nullptr;
}

std::pair<std::uint64_t, std::uint64_t> Segments::mesh_extent(std::uint64_t geometry,
                                                              const Message& fields) const {
  if (const StoredMesh* mesh = find_mesh(geometry)) return {mesh->position.shape[0], mesh->elements.shape[0]};
  const Array& position = require_table(fields, "structure", "position", "float64", 2);
  const Array& elements = require_table(fields, "structure", "elements", "uint64", 3);
  check_elements(elements, position.shape[0]);
  return {position.shape[0], elements.shape[0]};
}

void Segments::write_mesh(std::uint64_t geometry, const Message& fields) {
  if (find_mesh(geometry) != nullptr) return;
  const std::string group = fmt::format("/meshes/{:06}", geometry);
  const Array& position = require_table(fields, "structure", "position", "float64", 2);
  const Array& elements = require_table(fields, "structure", "elements", "uint64", 3);
  StoredMesh mesh;
  mesh.position = write(group + "/position", "position", position);
  mesh.elements = write(group + "/elements", "elements", elements);
  open_.meshes.emplace(geometry, std::move(mesh));
}

void Segments::write_network(const FractureNetwork& network) {
  const std::uint64_t revision = network.revision();
  if (closed_.networks.contains(revision) || open_.networks.contains(revision)) return;
  const std::string group = fmt::format("/networks/{:06}", revision);
  StoredNetwork stored;
  const Message topology = topology_arrays(network);
  for (const Array& array : topology.arrays) {
    const StoredArray location = write(group + "/" + array.name, array.name, array);
    if (array.name == "position") stored.position = location;
    if (array.name == "segments") stored.segments = location;
  }
  open_.networks.emplace(revision, std::move(stored));
}

StoredArray Segments::write(const std::string& dataset, const std::string& shown_name, const Array& array) {
  journal_.write(dataset, array);
  return {shown_name, array.dtype, array.unit, array.shape,
          fmt::format("segments/{}:{}", segment_name(segment_), dataset)};
}

}  // namespace fissura::coupler
