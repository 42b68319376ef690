// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/seismicity/source_record.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "common/errors.hpp"

using namespace fissura;

namespace {

/// A record in which no two numbers are the same.
SourceRecord record(double first) {
  SourceRecord r;
  r.kind = SourceKind::contact_slip;
  r.fracture = SourceFracture::natural;
  r.failing = true;
  r.line = 7;
  r.entity = 1234567890123;
  r.interval = 41;
  r.geometry = 3;
  double next = first;
  for (double* value : {&r.begin,
                        &r.end,
                        &r.centroid_time,
                        &r.position[0],
                        &r.position[1],
                        &r.extent,
                        &r.element_size,
                        &r.normal[0],
                        &r.normal[1],
                        &r.jump[0],
                        &r.jump[1],
                        &r.moment[0],
                        &r.moment[1],
                        &r.moment[2],
                        &r.moment[3],
                        &r.pseudo_moment[0],
                        &r.pseudo_moment[1],
                        &r.pseudo_moment[2],
                        &r.pseudo_moment[3],
                        &r.measure,
                        &r.peak_rate,
                        &r.shear_before,
                        &r.shear_after,
                        &r.normal_before,
                        &r.normal_after,
                        &r.fluid_pressure,
                        &r.mass_scale})
    *value = next += 0.1;
  return r;
}

}  // namespace

TEST_CASE("records of sources come through their arrays bit for bit", "[seismicity]") {
  std::vector<SourceRecord> given{record(1), record(100), SourceRecord{}};
  given[1].kind = SourceKind::bulk_tension;
  given[1].fracture = SourceFracture::none;
  given[1].failing = false;
  const std::vector<Array> arrays = arrays_of(given);
  CHECK(records_of(arrays) == given);
  CHECK(arrays_of({}).empty());
  CHECK(records_of({}).empty());
}

TEST_CASE("arrays of sources that are not whole are refused by name", "[seismicity]") {
  const std::vector<Array> whole = arrays_of({record(1), record(2)});
  for (std::size_t missing = 1; missing < whole.size(); ++missing) {
    std::vector<Array> arrays = whole;
    arrays.erase(arrays.begin() + static_cast<std::ptrdiff_t>(missing));
    CHECK_THROWS_WITH(records_of(arrays), Catch::Contains(whole[missing].name));
  }
  std::vector<Array> arrays = whole;
  arrays[0].bytes[0] = std::byte{9};
  CHECK_THROWS_AS(records_of(arrays), ProtocolError);
  arrays = whole;
  const double nothing = std::nan("");
  std::memcpy(arrays[2].bytes.data(), &nothing, sizeof nothing);
  CHECK_THROWS_AS(records_of(arrays), ValueError);
  arrays = whole;
  arrays[3].shape = {1, 2};
  CHECK_THROWS_AS(records_of(arrays), ProtocolError);
}

TEST_CASE("records have one order, whatever order they come in", "[seismicity]") {
  std::vector<SourceRecord> records;
  for (int k = 0; k < 24; ++k) {
    SourceRecord r;
    r.end = k % 2;
    r.kind = k % 3 == 0 ? SourceKind::bulk_shear : SourceKind::new_crack;
    r.entity = static_cast<std::uint64_t>(k / 2);
    records.push_back(r);
  }
  std::vector<SourceRecord> sorted = records;
  std::sort(sorted.begin(), sorted.end(), comes_before);
  std::reverse(records.begin(), records.end());
  std::sort(records.begin(), records.end(), comes_before);
  CHECK(records == sorted);
  CHECK(std::is_sorted(sorted.begin(), sorted.end(),
                       [](const SourceRecord& a, const SourceRecord& b) { return a.end < b.end; }));
  CHECK(in_bulk(sorted.front().kind));
}

TEST_CASE("records of sources without their kinds are refused, not passed over", "[common][seismicity]") {
  std::vector<Array> arrays = arrays_of({SourceRecord{}});
  REQUIRE(arrays.front().name == "source_kind");
  arrays.erase(arrays.begin());
  CHECK_THROWS_AS(records_of(arrays), ProtocolError);
  CHECK(records_of({}).empty());
}
