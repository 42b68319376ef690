// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <random>

#include "structure/seismicity/merge_records.hpp"
#include "structure/seismicity/source_moment.hpp"

using namespace fissura;
using namespace fissura::structure;

namespace {

// Whole numbers, so that sums are exact in any order.
std::vector<SourceRecord> many(std::size_t count) {
  std::mt19937 random(5);
  std::vector<SourceRecord> records;
  for (std::size_t k = 0; k < count; ++k) {
    SourceRecord record;
    record.kind = static_cast<SourceKind>(1 + random() % 6);
    record.line = in_bulk(record.kind) ? 0 : static_cast<std::uint32_t>(k % 3);
    record.failing = random() % 4 != 0;
    record.entity = k;
    record.begin = static_cast<double>(k);
    record.centroid_time = record.begin + 1;
    record.end = record.begin + 2;
    record.position = {static_cast<double>(k), 0};
    record.extent = 2;
    record.normal = {k % 2 == 0 ? 1.0 : -1.0, 0};
    record.jump = {k % 2 == 0 ? 3.0 : -3.0, 0};
    for (double& component : record.moment) component = static_cast<double>(random() % 1000) - 500;
    for (double& component : record.pseudo_moment) component = static_cast<double>(random() % 1000) - 500;
    record.shear_before = 7;
    records.push_back(record);
  }
  std::sort(records.begin(), records.end(), comes_before);
  return records;
}

}  // namespace

TEST_CASE("too many records are merged: none is dropped, sums stay to the bit", "[structure][seismicity]") {
  const std::vector<SourceRecord> records = many(1000);
  const SourceRecords result = merged(records, 100);
  CHECK(result.records.size() <= 100);
  CHECK(result.records.size() + result.merged == records.size());
  CHECK(std::is_sorted(result.records.begin(), result.records.end(), comes_before));
  PlaneTensor before{}, after{}, pseudo_before{}, pseudo_after{};
  double extent = 0;
  for (const SourceRecord& record : records) {
    before = before + record.moment;
    pseudo_before = pseudo_before + record.pseudo_moment;
  }
  for (const SourceRecord& record : result.records) {
    after = after + record.moment;
    pseudo_after = pseudo_after + record.pseudo_moment;
    extent += record.extent;
    CHECK(record.begin <= record.centroid_time);
    CHECK(record.centroid_time <= record.end);
    CHECK(record.shear_before == Approx(7));
    CHECK(std::abs(record.normal[0]) == Approx(1));
    CHECK(record.jump[0] * record.normal[0] == Approx(3));  // a normal and its jump turn together
  }
  CHECK(before == after);
  CHECK(pseudo_before == pseudo_after);
  CHECK(extent == 2000);
}

TEST_CASE("as many records as allowed are left alone, and lines and kinds are never mixed",
          "[structure][seismicity]") {
  const std::vector<SourceRecord> records = many(50);
  CHECK(merged(records, 50).records == records);
  CHECK(merged(records, 50).merged == 0);
  const SourceRecords fewest = merged(records, 1);
  CHECK(fewest.records.size() > 10);  // three kinds in the rock, three on each of three lines
}
