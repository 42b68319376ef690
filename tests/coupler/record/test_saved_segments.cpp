// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "common/errors.hpp"
#include "coupler/record/report_catalogue.hpp"
#include "coupler/record/segment_journal.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

Array numbers(const std::vector<std::uint64_t>& shape, std::size_t bytes) {
  Array array;
  array.dtype = "float64";
  array.shape = shape;
  array.bytes.resize(bytes);
  return array;
}

void save_and_restore(const Array& array) {
  SegmentJournal journal;
  journal.write("/reports/000001/network/pressure", array);
  ByteWriter archive;
  journal.save(archive);
  ByteReader saved(archive.bytes());
  SegmentJournal().restore(saved);
}

StoredArray stored(const std::vector<std::uint64_t>& shape) {
  return {"", "float64", "m", shape, "segments/000001.h5:/array"};
}

ReportCatalogue sound_catalogue() {
  ReportCatalogue catalogue;
  catalogue.meshes[3] = {stored({4, 2}), stored({2, 3})};
  catalogue.networks[5] = {stored({2, 2}), stored({0, 2})};
  StoredReport report;
  report.geometry = 3;
  report.revision = 5;
  report.joints = {stored({2, 2})};
  catalogue.reports = {report};
  return catalogue;
}

ReportCatalogue saved_and_restored(const ReportCatalogue& catalogue) {
  ByteWriter archive;
  put(archive, catalogue);
  ByteReader saved(archive.bytes());
  return get_catalogue(saved);
}

}  // namespace

TEST_CASE("an array of an open segment that no file could take is refused with the state",
          "[coupler][record][resume]") {
  CHECK_NOTHROW(save_and_restore(numbers({3, 2}, 48)));
  CHECK_NOTHROW(save_and_restore(numbers({0, 2}, 0)));
  CHECK_THROWS_AS(save_and_restore(numbers({3, 2}, 47)), Error);
  CHECK_THROWS_AS(save_and_restore(numbers({}, 8)), Error);
  constexpr std::uint64_t overflowing = std::uint64_t{1} << 32;
  CHECK_THROWS_AS(save_and_restore(numbers({overflowing, overflowing}, 0)), Error);
  Array unknown = numbers({1}, 8);
  unknown.dtype = "float46";
  CHECK_THROWS_AS(save_and_restore(unknown), Error);
}

TEST_CASE("a catalogue of reports with shapes that no report has is refused", "[coupler][record][resume]") {
  CHECK_NOTHROW(saved_and_restored(sound_catalogue()));
  for (const std::vector<std::uint64_t>& shape :
       {std::vector<std::uint64_t>{}, {4}, {4, 4}, {std::uint64_t{1} << 60, 2}}) {
    INFO("rank " << shape.size());
    ReportCatalogue network = sound_catalogue();
    network.networks.at(5).position.shape = shape;
    CHECK_THROWS_AS(saved_and_restored(network), Error);
  }
  ReportCatalogue mesh = sound_catalogue(), joints = sound_catalogue(), nodes = sound_catalogue();
  mesh.meshes.at(3).elements.shape = {2, 4};
  CHECK_THROWS_AS(saved_and_restored(mesh), Error);
  joints.reports[0].joints[0].shape = {std::uint64_t{1} << 60, 2};
  CHECK_THROWS_AS(saved_and_restored(joints), Error);
  nodes.reports[0].mesh_nodes = {stored({})};
  CHECK_THROWS_AS(saved_and_restored(nodes), Error);
}

TEST_CASE("a report whose mesh or network is nowhere is refused", "[coupler][record][resume]") {
  const ReportCatalogue sound = sound_catalogue();
  ReportCatalogue networks_only = sound, meshes_only = sound;
  networks_only.meshes.clear();
  meshes_only.networks.clear();
  CHECK_NOTHROW(require_meshes_and_networks(sound.reports, {&sound}));
  CHECK_NOTHROW(require_meshes_and_networks(sound.reports, {&networks_only, &meshes_only}));
  CHECK_THROWS_AS(require_meshes_and_networks(sound.reports, {&networks_only}), Error);
  CHECK_THROWS_AS(require_meshes_and_networks(sound.reports, {&meshes_only}), Error);
}
