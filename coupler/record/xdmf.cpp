// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "coupler/record/checked_file.hpp"

namespace fissura::coupler {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

/// XDMF knows no unsigned 64-bit integers; ours are indices and ids, read as signed.
const char* number_type(const StoredArray& array) {
  if (array.dtype == "float64") return R"(NumberType="Float" Precision="8")";
  if (array.dtype == "uint8") return R"(NumberType="UChar" Precision="1")";
  return R"(NumberType="Int" Precision="8")";
}

std::string data_item(const StoredArray& array) {
  return fmt::format(R"(<DataItem Format="HDF" {} Dimensions="{}">{}</DataItem>)", number_type(array),
                     fmt::join(array.shape, " "), escaped(array.location));
}

const char* attribute_type(const StoredArray& array) {
  if (array.shape.size() == 1) return "Scalar";
  return array.shape.back() == 3 ? "Vector" : "Matrix";
}

void append_attributes(std::string& xml, const std::vector<StoredArray>& arrays, const char* center) {
  for (const StoredArray& array : arrays)
    xml += fmt::format(R"(        <Attribute Name="{}" AttributeType="{}" Center="{}">
          <Information Name="unit" Value="{}"/>
          {}
        </Attribute>
)",
                       escaped(array.name), attribute_type(array), center, escaped(array.unit),
                       data_item(array));
}

/// Without a segment there is nothing to draw but the nodes.
std::string points(std::uint64_t count) {
  std::vector<std::uint64_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::uint64_t{0});
  return fmt::format(R"(<Topology TopologyType="Polyvertex" NumberOfElements="{}" NodesPerElement="1">)"
                     R"(<DataItem Format="XML" NumberType="Int" Dimensions="{} 1">{}</DataItem></Topology>)",
                     count, count, fmt::join(indices, " "));
}

std::string lines_or_points(const StoredNetwork& network) {
  const std::uint64_t segments = network.segments.shape[0];
  if (segments == 0) return points(network.position.shape[0]);
  return fmt::format(
      R"(<Topology TopologyType="Polyline" NumberOfElements="{}" NodesPerElement="2">{}</Topology>)",
      segments, data_item(network.segments));
}

std::string triangles(const StoredMesh& mesh) {
  return fmt::format(R"(<Topology TopologyType="Triangle" NumberOfElements="{}">{}</Topology>)",
                     mesh.elements.shape[0], data_item(mesh.elements));
}

void append_grid(std::string& xml, const StoredReport& report, const std::string& topology,
                 const StoredArray& position, const std::vector<StoredArray>& nodes,
                 const std::vector<StoredArray>& cells) {
  xml += fmt::format(R"(      <Grid Name="report {}" GridType="Uniform">
        <Time Value="{}"/>
        {}
        <Geometry GeometryType="XY">{}</Geometry>
)",
                     report.number, report.time, topology, data_item(position));
  append_attributes(xml, nodes, "Node");
  append_attributes(xml, cells, "Cell");
  xml += "      </Grid>\n";
}

std::string document(const char* name, const std::string& grids) {
  return fmt::format(R"(<?xml version="1.0"?>
<Xdmf Version="2.0">
  <Domain>
    <Grid Name="{}" GridType="Collection" CollectionType="Temporal">
{}    </Grid>
  </Domain>
</Xdmf>
)",
                     name, grids);
}

}  // namespace

std::string fields_xdmf(const ReportCatalogue& catalogue) {
  std::string grids;
  for (const StoredReport& report : catalogue.reports) {
    const StoredMesh& mesh = catalogue.meshes.at(report.geometry);
    append_grid(grids, report, triangles(mesh), mesh.position, report.mesh_nodes, report.mesh_elements);
  }
  return document("rock", grids);
}

std::string fractures_xdmf(const ReportCatalogue& catalogue) {
  std::string grids;
  for (const StoredReport& report : catalogue.reports) {
    const StoredNetwork& network = catalogue.networks.at(report.revision);
    if (network.position.shape[0] == 0) continue;
    append_grid(grids, report, lines_or_points(network), network.position, report.network_nodes,
                report.network_segments);
  }
  return document("fractures", grids);
}

std::string joints_xdmf(const ReportCatalogue& catalogue) {
  std::string grids;
  for (const StoredReport& report : catalogue.reports) {
    std::vector<StoredArray> values = report.joints;
    const auto position = std::find_if(values.begin(), values.end(),
                                       [](const StoredArray& array) { return array.name == "position"; });
    if (position == values.end() || position->shape[0] == 0) continue;
    const StoredArray points_of_grid = *position;
    values.erase(position);
    append_grid(grids, report, points(points_of_grid.shape[0]), points_of_grid, values, {});
  }
  return document("joints", grids);
}

void write_xdmf(const std::filesystem::path& run_directory, const ReportCatalogue& catalogue) {
  write_whole_file(run_directory / "fields.xdmf", fields_xdmf(catalogue));
  write_whole_file(run_directory / "fractures.xdmf", fractures_xdmf(catalogue));
  const bool has_joints = std::any_of(catalogue.reports.begin(), catalogue.reports.end(),
                                      [](const StoredReport& report) { return !report.joints.empty(); });
  if (has_joints) write_whole_file(run_directory / "joints.xdmf", joints_xdmf(catalogue));
}

}  // namespace fissura::coupler
