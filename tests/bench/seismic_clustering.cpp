// SPDX-License-Identifier: GPL-3.0-or-later

/// Time to make events of a million records of sources, in one thread: on the clock and of the processor.
///
///   cmake --build build/release --target seismic_clustering
///   build/release/bin/seismic_clustering
///
/// Sixty natural fractures and a row of elements beside each, in a square of 400 m; a front runs over them,
/// and in each coupling interval fifty of the entities near it fail. Element sizes differ fourfold. "Wide
/// links" join what is within 10 m and 0.1 s.

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>

#include "coupler/seismicity/extraction.hpp"

namespace {

using namespace fissura;
using namespace fissura::coupler;

constexpr int lines = 60, units_per_line = 400;
constexpr int intervals = 20000, failures = 50;
constexpr double side = 400;        // [m]
constexpr double interval = 5e-3;   // [s]
constexpr double mass_scale = 100;  // [-]

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

ExtractionControls shale() {
  ExtractionControls controls;
  controls.thickness = 10;
  controls.shear = 32e9 / 2.4;
  controls.lame = controls.shear * 2 / 3;
  controls.shear_wave_speed = std::sqrt(controls.shear / 2400);
  return controls;
}

/// Slip of 0.1 mm on a fracture, or an opening of that size.
SourceRecord failure(int line, int unit, double begin, std::mt19937_64& random) {
  SourceRecord record;
  record.kind = uniform(random) < 0.7 ? SourceKind::contact_slip : SourceKind::bulk_tension;
  const bool bulk = in_bulk(record.kind);
  record.fracture = bulk ? SourceFracture::none : SourceFracture::natural;
  record.failing = true;
  record.line = static_cast<std::uint32_t>(line);
  record.entity = static_cast<std::uint64_t>(line) * units_per_line + static_cast<std::uint64_t>(unit);
  record.begin = begin + 0.3 * interval * uniform(random);
  record.end = record.begin + 0.6 * interval * uniform(random);
  record.centroid_time = 0.5 * (record.begin + record.end);
  record.element_size = 0.5 + 1.5 * ((line * 7) % lines) / lines;
  record.position = {(unit + 0.5) * side / units_per_line, (line + 0.5) * side / lines + (bulk ? 0.5 : 0)};
  record.extent = 10 * record.element_size * (bulk ? record.element_size : 1);
  record.normal = {0, 1};
  const double moment = 1e6 * uniform(random);
  if (bulk)
    record.moment = {moment / 4, moment, moment / 4, 0};
  else
    record.moment = {0, 0, 0, moment}, record.jump = {1e-4, 0};
  record.peak_rate = 0.1;
  record.shear_before = 2e6;
  record.shear_after = 1e6;
  record.mass_scale = mass_scale;
  return record;
}

std::vector<SourceRecord> failures_of(int k, std::mt19937_64& random) {
  const int line = k % lines;
  const int front = static_cast<int>(static_cast<double>(k) / intervals * units_per_line);
  std::vector<SourceRecord> records;
  for (int i = 0; i < failures; ++i) {
    const int unit = std::min(front + static_cast<int>(20 * uniform(random)), units_per_line - 1);
    records.push_back(failure((line + i % 3) % lines, unit, k * interval, random));
  }
  return records;
}

void measure(const char* how, const ExtractionControls& controls,
             const std::vector<std::vector<SourceRecord>>& calls, double end) {
  Extraction extraction(controls);
  std::size_t records = 0, events = 0;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t begin = std::clock();
  for (std::size_t k = 0; k < calls.size(); ++k) {
    records += calls[k].size();
    events +=
        extraction.advance(end * static_cast<double>(k + 1) / static_cast<double>(calls.size()), calls[k])
            .size();
  }
  events += extraction.finish().size();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double busy = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const SeismicSums& sums = extraction.sums();
  fmt::print("{:12} {:9} {:9} {:9.3f} {:9.3f} {:9} {:12.6e}\n", how, calls.size(), records, seconds, busy,
             events, sums.event_moment);
}

}  // namespace

int main() {
  std::mt19937_64 random(5);
  std::vector<std::vector<SourceRecord>> calls;
  std::vector<SourceRecord> together;
  for (int k = 0; k < intervals; ++k) {
    calls.push_back(failures_of(k, random));
    together.insert(together.end(), calls.back().begin(), calls.back().end());
  }
  std::shuffle(together.begin(), together.end(), random);
  fmt::print("records in       calls   records   clock/s    busy/s    events  event moment / N m\n");
  ExtractionControls controls = shale();
  measure("intervals", controls, calls, intervals * interval);
  measure("one call", controls, {together}, intervals * interval);
  controls.thresholds.cluster_radius = 10;
  controls.thresholds.cluster_time = 0.1;
  measure("wide links", controls, calls, intervals * interval);
}
