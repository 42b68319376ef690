// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <thread>

#include "tests/coupler/record/sample_run.hpp"
#include "tests/coupler/record/scripted_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("two runs of the same case leave the same bytes, whatever the time", "[coupler][record]") {
  const sample::TemporaryDirectory one, other;
  sample::record_run(one.path(), 22);
  // Longer than the second in which HDF5 would count times.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  sample::record_run(other.path(), 22);
  const auto files = sample::comparable_files(one.path());
  CHECK(files.contains("segments/000003.h5"));
  CHECK(files.contains("meetings.csv"));
  CHECK(sample::differences(files, sample::comparable_files(other.path())) == std::vector<std::string>());
}

TEST_CASE("a segment is closed when its arrays are large, however few its reports", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 1000);
  Message large = sample::structure_fields(0, 0, 0);
  for (int i = 0; i < 9; ++i)
    large.add("large_" + std::to_string(i), "1", std::vector<double>(4 << 18), 4, 1 << 18);
  CHECK(segments.add(1, large, sample::network_fields(network), network, sample::node_fields(network, 1)));
  CHECK(segments.closed().reports.size() == 1);
  CHECK_FALSE(segments.add(2, sample::structure_fields(2, 0, 0), sample::network_fields(network), network,
                           sample::node_fields(network, 2)));
}
