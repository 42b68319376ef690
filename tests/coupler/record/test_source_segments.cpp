// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/segments.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

std::vector<SourceRecord> records(double time, std::size_t count) {
  std::vector<SourceRecord> list(count);
  for (std::size_t i = 0; i < count; ++i) {
    list[i].kind = SourceKind::new_crack;
    list[i].entity = 100 + i;
    list[i].begin = time - 0.1;
    list[i].end = list[i].centroid_time = time;
    list[i].moment = {1.0 + static_cast<double>(i), 2, 3, -4};
  }
  return list;
}

std::vector<SourceRecord> records_in(const Hdf5File& file, const std::string& group) {
  std::vector<Array> arrays;
  for (const Array& sample : arrays_of(records(0, 1))) {
    Array array = file.read(group + "/" + sample.name);
    array.name = sample.name;
    arrays.push_back(std::move(array));
  }
  return records_of(arrays);
}

nlohmann::json last_index_line(const std::filesystem::path& run_directory) {
  return nlohmann::json::parse(sample::lines(run_directory / "segments" / "index.jsonl").back());
}

}  // namespace

TEST_CASE("records of sources are read back from their segment bit for bit",
          "[coupler][record][seismicity]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 1);
  segments.add_sources(0.5, records(0.5, 3));
  CHECK(segments.add(0.5, sample::structure_fields(0.5, 0, 0), sample::network_fields(network), network,
                     sample::node_fields(network, 0.5)));
  segments.add_sources(0.7, records(0.7, 2));
  CHECK(segments.add(1, sample::without_mesh(sample::structure_fields(1, 0, 0)),
                     sample::network_fields(network), network, sample::node_fields(network, 1)));

  const Hdf5File first = Hdf5File::open(folder.path() / "segments" / "000001.h5");
  const Hdf5File second = Hdf5File::open(folder.path() / "segments" / "000002.h5");
  CHECK(records_in(first, "/sources/000001") == records(0.5, 3));
  CHECK(first.read_number("/sources/000001", "time") == 0.5);
  CHECK(records_in(second, "/sources/000002") == records(0.7, 2));
  CHECK(first.read("/sources/000001/source_moment").unit == "N m");
  CHECK(last_index_line(folder.path())["sources"] == nlohmann::json{2, 2});
  CHECK(last_index_line(folder.path())["reports"] == nlohmann::json{2, 2});
}

TEST_CASE("records that wait when a run ends before its first report are not lost",
          "[coupler][record][seismicity]") {
  const sample::TemporaryDirectory folder;
  Segments segments(folder.path(), 20);
  segments.add_sources(0.2, records(0.2, 5));
  CHECK(segments.close());
  CHECK(segments.closed().reports.empty());
  REQUIRE(segments.closed().sources.size() == 1);
  const Hdf5File file = Hdf5File::open(folder.path() / "segments" / "000001.h5");
  CHECK(records_in(file, "/sources/000001").size() == 5);
  const nlohmann::json line = last_index_line(folder.path());
  CHECK(line["sources"] == nlohmann::json{1, 1});
  CHECK(line["reports"] == nlohmann::json{1, 0});
  CHECK(line["time"].empty());
}

TEST_CASE("an interval without sources writes nothing", "[coupler][record][seismicity]") {
  const sample::TemporaryDirectory folder;
  Segments segments(folder.path(), 20);
  segments.add_sources(0.2, {});
  CHECK_FALSE(segments.close());
  CHECK_FALSE(std::filesystem::exists(folder.path() / "segments"));
}
