// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/segments.hpp"
#include "coupler/record/xdmf.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

/// Every tag is closed, in order, and every ampersand starts an entity.
bool is_well_formed(const std::string& xml) {
  static const std::regex tag(R"(<(/?)(\w+)((?:\s+[\w:]+="[^"<]*")*)\s*(/?)>|<\?xml[^>]*\?>)");
  static const std::regex entity("&(?!(amp|lt|gt|quot);)");
  if (std::regex_search(xml, entity)) return false;
  std::vector<std::string> open;
  std::size_t angles = 0;
  for (std::sregex_iterator match(xml.begin(), xml.end(), tag), end; match != end; ++match) {
    ++angles;
    const std::string name = (*match)[2];
    if (name.empty()) continue;
    if ((*match)[1].length() > 0) {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    } else if ((*match)[4].length() == 0) {
      open.push_back(name);
    }
  }
  return open.empty() && angles > 0 &&
         angles == static_cast<std::size_t>(std::count(xml.begin(), xml.end(), '<'));
}

struct DataItem {
  std::vector<std::uint64_t> shape;
  std::string file, dataset;
};

std::vector<DataItem> data_items(const std::string& xml) {
  static const std::regex item(
      R"re(<DataItem [^>]*Dimensions="([0-9 ]+)"[^>]*>([^:<]+):([^<]+)</DataItem>)re");
  std::vector<DataItem> items;
  for (std::sregex_iterator match(xml.begin(), xml.end(), item), end; match != end; ++match) {
    DataItem found{{}, (*match)[2], (*match)[3]};
    std::istringstream extents((*match)[1].str());
    for (std::uint64_t extent; extents >> extent;) found.shape.push_back(extent);
    items.push_back(found);
  }
  return items;
}

std::vector<std::uint64_t> indices_of(const std::filesystem::path& directory, const StoredArray& stored) {
  const std::size_t colon = stored.location.find(':');
  const Array array =
      Hdf5File::open(directory / stored.location.substr(0, colon)).read(stored.location.substr(colon + 1));
  std::vector<std::uint64_t> indices(array.bytes.size() / sizeof(std::uint64_t));
  std::memcpy(indices.data(), array.bytes.data(), array.bytes.size());
  return indices;
}

void record_three_reports(Segments& segments) {
  const FractureNetwork before = sample::network(), after = sample::grown_network();
  Message third = sample::structure_fields(3, 1, 1);
  third.add_bytes("broken", std::vector<std::byte>(third.arrays[3].shape[0]));
  segments.add(1, sample::structure_fields(1, 0, 0), sample::network_fields(before), before,
               sample::node_fields(before, 1));
  segments.add(2, sample::without_mesh(sample::structure_fields(2, 0, 0)), sample::network_fields(before),
               before, sample::node_fields(before, 2));
  segments.add(3, third, sample::network_fields(after), after, sample::node_fields(after, 3));
  segments.close();
}

}  // namespace

TEST_CASE("every dataset that XDMF names exists with the stated dimensions", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  Segments segments(folder.path(), 2);
  record_three_reports(segments);
  write_xdmf(folder.path(), segments.closed());

  for (const char* name : {"fields.xdmf", "fractures.xdmf"}) {
    INFO(name);
    const std::string xml = sample::content(folder.path() / name);
    CHECK(is_well_formed(xml));
    const auto items = data_items(xml);
    // Three reports with topology, geometry, and (fields) displacement and stress, (fractures) three node
    // values.
    CHECK(items.size() == (std::string(name) == "fields.xdmf" ? 3 * 4 + 1 : 3 * 5));
    for (const DataItem& item : items) {
      INFO(item.file << ":" << item.dataset);
      CHECK(Hdf5File::open(folder.path() / item.file).describe(item.dataset).shape == item.shape);
    }
  }
}

TEST_CASE("XDMF names only closed segments", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 2);
  record_three_reports(segments);
  segments.add(4, sample::structure_fields(4, 1, 1), sample::network_fields(network), network,
               sample::node_fields(network, 4));
  const std::string xml = fields_xdmf(segments.closed());
  CHECK(xml.find("<Time Value=\"3\"/>") != std::string::npos);
  CHECK(xml.find("<Time Value=\"4\"/>") == std::string::npos);
  CHECK(xml.find("000003.h5") == std::string::npos);
}

TEST_CASE("a run without field reports has XDMF files without grids", "[coupler][record]") {
  CHECK(is_well_formed(fields_xdmf({})));
  CHECK(is_well_formed(fractures_xdmf({})));
}

TEST_CASE("units with markup signs keep the XML well formed", "[coupler][record]") {
  ReportCatalogue catalogue;
  StoredArray array{"odd", "float64", "a<b & \"c\"", {1}, "segments/000001.h5:/odd"};
  catalogue.meshes[0] = {array, array};
  catalogue.reports.push_back({1, 0.5, 0, 0, {array}, {}, {}, {}, {}});
  CHECK(is_well_formed(fields_xdmf(catalogue)));
}

TEST_CASE("a fracture network without segments is drawn as points", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  Insertion one_node;
  one_node.new_nodes = {{10, 0, 0, 0.5, 1, NodeRole::perforation, 0}};
  FractureNetwork network;
  network.apply(one_node);
  Segments segments(folder.path(), 1);
  segments.add(1, sample::structure_fields(1, 0, 0), sample::network_fields(network), network,
               sample::node_fields(network, 1));
  const std::string xml = fractures_xdmf(segments.closed());
  CHECK(is_well_formed(xml));
  CHECK(xml.find("TopologyType=\"Polyvertex\" NumberOfElements=\"1\"") != std::string::npos);
  CHECK(xml.find("Polyline") == std::string::npos);
}

TEST_CASE("a network without nodes is stored, and nothing is drawn of it", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  FractureNetwork network;
  network.apply(Insertion{});
  Segments segments(folder.path(), 1);
  segments.add(1, sample::structure_fields(1, 0, 0), sample::network_fields(network), network,
               sample::node_fields(network, 1));
  CHECK(segments.closed().networks.at(0).position.shape == std::vector<std::uint64_t>{0, 2});
  const std::string xml = fractures_xdmf(segments.closed());
  CHECK(is_well_formed(xml));
  CHECK(xml.find("Topology") == std::string::npos);
}

TEST_CASE("every report is drawn on the mesh it was made with", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  Segments segments(folder.path(), 2);
  const FractureNetwork network = sample::network();
  for (const std::uint64_t geometry : {0, 1, 2})
    segments.add(1. + static_cast<double>(geometry), sample::structure_fields(0, geometry, geometry),
                 sample::network_fields(network), network, sample::node_fields(network, 1));
  segments.close();
  const std::string xml = fields_xdmf(segments.closed());
  std::size_t place = 0;
  for (const std::uint64_t geometry : {0, 1, 2}) {
    const std::string group = fmt::format(":/meshes/{:06}/elements", geometry);
    place = xml.find(group, place);
    REQUIRE(place != std::string::npos);
    const auto& mesh = segments.closed().meshes.at(geometry);
    CHECK(mesh.position.shape[0] == 4 + geometry);
    for (const std::uint64_t corner : indices_of(folder.path(), mesh.elements))
      CHECK(corner < mesh.position.shape[0]);
  }
}

TEST_CASE("contact units are points with their values; without any there is no file of them",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 1);
  const auto add = [&](double time, const Message& structure) {
    segments.add(time, structure, sample::network_fields(network), network,
                 sample::node_fields(network, time));
    write_xdmf(folder.path(), segments.closed());
  };
  add(1, sample::structure_fields(1, 0, 0));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "joints.xdmf"));
  add(2, sample::with_joints(sample::structure_fields(2, 0, 0), 2));
  const std::string xml = sample::content(folder.path() / "joints.xdmf");
  CHECK(is_well_formed(xml));
  const auto items = data_items(xml);
  // Position as geometry; normal, slip and kind as values.
  CHECK(items.size() == 4);
  for (const DataItem& item : items)
    CHECK(Hdf5File::open(folder.path() / item.file).describe(item.dataset).shape == item.shape);
  CHECK(xml.find("Polyvertex") != std::string::npos);
  CHECK(xml.find("<Time Value=\"1\"/>") == std::string::npos);
}
