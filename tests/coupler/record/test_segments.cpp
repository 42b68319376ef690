// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/hash.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/segments.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

bool add(Segments& segments, double time, const Message& structure, const FractureNetwork& network) {
  return segments.add(time, structure, sample::network_fields(network), network,
                      sample::node_fields(network, time));
}

}  // namespace

TEST_CASE("a field report can be read as soon as its segment is closed, and not before",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const auto first = folder.path() / "segments" / "000001.h5";
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 2);

  CHECK_FALSE(add(segments, 0.5, sample::structure_fields(0.5, 0, 0), network));
  CHECK_FALSE(std::filesystem::exists(first));
  CHECK(segments.closed().reports.empty());
  CHECK(add(segments, 1.0, sample::without_mesh(sample::structure_fields(1.0, 0, 0)), network));
  CHECK(std::filesystem::exists(first));
  CHECK_FALSE(std::filesystem::exists(first.string() + ".part"));

  const Hdf5File file = Hdf5File::open(first);
  CHECK(file.read_number("/reports/000002", "time") == 1.0);
  CHECK(sample::doubles(file.read("/reports/000002/structure/displacement")) ==
        std::vector<double>{1, 1, 0, 2, 11, 0, 3, 21, 0, 4, 31, 0});
  CHECK(file.read("/reports/000001/structure/displacement").unit == "m");
  CHECK(sample::doubles(file.read("/reports/000001/fractures/aperture")) ==
        std::vector<double>{1e-4 + 0.5, 2e-4 + 0.5, 1e-4 * 3 + 0.5});
  CHECK(sample::doubles(file.read("/reports/000001/network/content")) == std::vector<double>(3, 1e-4));
  CHECK(sample::doubles(file.read("/networks/000000/position")) == std::vector<double>{-1, 0, 0, 0, 1, 0});
}

TEST_CASE("mesh and network are written once for each of their numbers and found from every report",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork before = sample::network(), after = sample::grown_network();
  Segments segments(folder.path(), 1);
  add(segments, 1, sample::structure_fields(1, 0, 0), before);
  add(segments, 2, sample::structure_fields(2, 0, 0), before);
  add(segments, 3, sample::structure_fields(3, 1, 2), after);

  const ReportCatalogue& catalogue = segments.closed();
  REQUIRE(catalogue.reports.size() == 3);
  CHECK(catalogue.meshes.at(0).position.location == "segments/000001.h5:/meshes/000000/position");
  CHECK(catalogue.meshes.at(1).position.location == "segments/000003.h5:/meshes/000001/position");
  CHECK(catalogue.meshes.at(1).elements.shape == std::vector<std::uint64_t>{4, 3});
  CHECK(catalogue.networks.at(1).segments.shape == std::vector<std::uint64_t>{3, 2});
  CHECK(catalogue.reports[1].geometry == 0);
  CHECK(catalogue.reports[2].revision == 1);
  const Hdf5File second = Hdf5File::open(folder.path() / "segments" / "000002.h5");
  CHECK_THROWS_AS(second.describe("/meshes/000000/position"), StorageError);
}

TEST_CASE("the index names every closed segment with its hash, times and revisions", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  Segments segments(folder.path(), 2);
  add(segments, 1, sample::structure_fields(1, 0, 0), sample::network());
  add(segments, 2, sample::structure_fields(2, 0, 0), sample::grown_network());
  add(segments, 3, sample::structure_fields(3, 0, 0), sample::grown_network());
  CHECK(segments.close());
  CHECK_FALSE(segments.close());

  const auto lines = sample::lines(folder.path() / "segments" / "index.jsonl");
  REQUIRE(lines.size() == 2);
  const auto first = nlohmann::json::parse(lines[0]), second = nlohmann::json::parse(lines[1]);
  CHECK(first["file"] == "000001.h5");
  CHECK(first["sha256"] == sha256_of_file(folder.path() / "segments" / "000001.h5"));
  CHECK(first["reports"] == nlohmann::json({1, 2}));
  CHECK(first["time"] == nlohmann::json({1.0, 2.0}));
  CHECK(first["revision"] == nlohmann::json({0, 1}));
  CHECK(first["networks"] == nlohmann::json({0, 1}));
  CHECK(second["time"] == nlohmann::json({3.0, 3.0}));
  CHECK(second["meshes"].empty());
}

TEST_CASE("fields that do not fit mesh or network are refused by name, and nothing is written",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 1);
  Message fields = sample::structure_fields(0, 0, 0);
  const auto refused = [&](const std::string& word) {
    CHECK_THROWS_AS(add(segments, 0, fields, network), ProtocolError);
    CHECK_THROWS_WITH(add(segments, 0, fields, network), Catch::Contains(word));
  };
  SECTION("rows of neither nodes nor elements") {
    fields.add("velocity", "m/s", std::vector<double>(9));
    refused("\"velocity\" of the structure has 9 rows; 4 (nodes) or 2 (cells)");
  }
  SECTION("a name that is a path") {
    fields.add("../mesh", "1", std::vector<double>(4));
    refused("../mesh");
  }
  SECTION("a name twice") {
    fields.add("displacement", "m", std::vector<double>(4));
    refused("\"displacement\" of the structure comes twice");
  }
  SECTION("a new geometry without its mesh") {
    fields = sample::without_mesh(fields);
    refused("lack \"position\"");
  }
  SECTION("an element outside the mesh") {
    const std::uint64_t outside = 4;
    for (Array& array : fields.arrays)
      if (array.name == "elements") std::memcpy(array.bytes.data(), &outside, sizeof(outside));
    refused("name node 4; the mesh has 4 nodes");
  }
  SECTION("no geometry number") {
    fields.body.erase("geometry");
    refused("geometry");
  }
  SECTION("bytes that are not those of the shape") {
    fields.arrays.back().bytes.pop_back();
    refused("\"stress\"");
  }
  CHECK_FALSE(std::filesystem::exists(folder.path() / "segments"));
}

TEST_CASE("contact units are stored beside the mesh fields, however many there are", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 2);
  add(segments, 1, sample::structure_fields(1, 0, 0), network);
  add(segments, 2, sample::with_joints(sample::structure_fields(2, 0, 0), 2), network);
  CHECK(segments.closed().reports[0].joints.empty());
  CHECK(segments.closed().reports[1].joints.size() == 4);
  const Hdf5File file = Hdf5File::open(folder.path() / "segments" / "000001.h5");
  CHECK(sample::doubles(file.read("/reports/000002/joints/slip")) == std::vector<double>{2, -2});
  CHECK(file.read("/reports/000002/joints/slip").unit == "m");
  CHECK(sample::doubles(file.read("/reports/000002/joints/position")) ==
        std::vector<double>{0.25, 0.5, 0.75, 0.5});
  CHECK(sample::doubles(file.read("/reports/000002/joints/normal")) ==
        std::vector<double>{0, 1, 0, 0.6, 0.8, 0});
  CHECK_FALSE(file.has("/reports/000002/structure/joint_slip"));
}

TEST_CASE("contact units without a place, or with another number of rows, are refused", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 1);
  Message fields = sample::structure_fields(0, 0, 0);
  fields.add("joint_slip", "m", std::vector<double>(2));
  CHECK_THROWS_WITH(add(segments, 0, fields, network), Catch::Contains("lack \"joint_position\""));
  fields.add("joint_position", "m", std::vector<double>(6), 3, 2);
  CHECK_THROWS_WITH(add(segments, 0, fields, network),
                    Catch::Contains("\"joint_slip\" of the structure has 2 rows; 3"));
}
