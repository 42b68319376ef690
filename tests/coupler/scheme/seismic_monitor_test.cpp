// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/seismic_monitor.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <map>

#include "common/errors.hpp"
#include "tests/coupler/seismicity/catalogue/sample_events.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t last = 12;

/// Clusters stay open beyond the end of an interval, but not of the next one.
Case open_case() {
  Case value = sample::placed_case();
  value.seismicity.active = true;
  value.seismicity.cluster_time = 0.6;
  value.seismicity.rest_time = 0.1;
  return value;
}

void listen(SeismicMonitor& monitor, std::uint64_t first, std::uint64_t end) {
  static const std::vector<SourceRecord> all = sample::random_sources(100 * last, 7);
  for (std::uint64_t interval = first; interval <= end; ++interval) {
    std::vector<SourceRecord> now;
    for (const SourceRecord& record : all)
      if (record.interval == interval) now.push_back(record);
    monitor.listen(static_cast<double>(interval), now);
  }
}

void finish(SeismicMonitor& monitor) {
  monitor.conclude();
  monitor.finish({{"events", monitor.events().size()}});
}

std::map<std::string, std::string> files(const fs::path& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::directory_iterator(folder))
    found[entry.path().filename()] = sample::content(entry.path());
  return found;
}

std::vector<std::byte> begun(const Case& run_case, const fs::path& folder, std::uint64_t saved,
                             std::uint64_t end) {
  SeismicMonitor monitor(run_case);
  monitor.begin(folder, "00ff", "2026-01-01T00:00:00Z");
  listen(monitor, 1, saved);
  const std::vector<std::byte> state = monitor.save();
  listen(monitor, saved + 1, end);
  // As a failing run ends.
  monitor.conclude();
  monitor.flush();
  return state;
}

}  // namespace

TEST_CASE("a catalogue whose run was ended with open clusters and went on is that of one that was not",
          "[coupler][scheme][seismicity][resume]") {
  const Case run_case = open_case();
  const sample::TemporaryDirectory straight;
  {
    SeismicMonitor monitor(run_case);
    monitor.begin(straight.path(), "00ff", "2026-01-01T00:00:00Z");
    listen(monitor, 1, last);
    const std::size_t closed = monitor.events().size();
    finish(monitor);
    REQUIRE(closed > 0);
    REQUIRE(monitor.events().size() > closed);
  }
  const auto expected = files(straight.path());
  REQUIRE(expected.size() == 5);
  for (const std::uint64_t saved : {0, 1, 5, 11, 12}) {
    INFO("saved after " << saved);
    const sample::TemporaryDirectory folder;
    const std::vector<std::byte> state = begun(run_case, folder.path(), saved, std::min(saved + 3, last));
    SeismicMonitor monitor(run_case);
    SeismicMonitor::check(folder.path(), state);
    monitor.resume(folder.path(), "00ff", "2026-01-01T00:00:00Z", state);
    listen(monitor, saved + 1, last);
    finish(monitor);
    const auto found = files(folder.path());
    for (const auto& [name, content] : expected) {
      INFO(name);
      CHECK((found.contains(name) && found.at(name) == content));
    }
    CHECK(found.size() == expected.size());
  }
}

TEST_CASE("a catalogue that was cut off or changed since is named, and nothing is changed",
          "[coupler][scheme][seismicity][resume]") {
  const Case run_case = open_case();
  const sample::TemporaryDirectory folder;
  const std::vector<std::byte> state = begun(run_case, folder.path(), 6, 7);
  const fs::path table = folder.path() / "catalogue.csv";
  const std::string sound = sample::content(table);
  std::string flipped = sound;
  flipped[sound.size() / 10] ^= 1;
  for (const std::string& damaged : {flipped, sound.substr(0, sound.size() / 10), std::string()}) {
    std::ofstream(table, std::ios::binary | std::ios::trunc) << damaged;
    SeismicMonitor monitor(run_case);
    CHECK_THROWS_WITH(monitor.resume(folder.path(), "00ff", "", state), Catch::Contains("catalogue.csv"));
    CHECK((sample::content(table) == damaged));
  }
  fs::remove(table);
  CHECK_THROWS_WITH(SeismicMonitor::check(folder.path(), state), Catch::Contains("catalogue.csv"));
}

TEST_CASE("a run without seismicity keeps its sums through a checkpoint", "[coupler][scheme][resume]") {
  Case run_case = open_case();
  run_case.seismicity.active = false;
  const sample::TemporaryDirectory folder;
  const std::vector<std::byte> state = begun(run_case, folder.path() / "none", 6, 6);
  SeismicMonitor resumed(run_case), straight(run_case);
  resumed.resume(folder.path() / "none", "00ff", "", state);
  listen(straight, 1, 6);
  CHECK(resumed.figures().events == straight.figures().events);
  CHECK(resumed.figures().source_moment == straight.figures().source_moment);
  CHECK(fs::is_empty(folder.path()));
  const Case active = open_case();
  CHECK_THROWS_AS(SeismicMonitor(active).resume(folder.path(), "00ff", "", state), Error);
}
