// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <numbers>

#include "common/errors.hpp"
#include "coupler/seismicity/catalogue/event_columns.hpp"
#include "tests/coupler/seismicity/catalogue/sample_events.hpp"

using namespace fissura;
using namespace fissura::coupler;
using Catch::Matchers::Contains;

namespace {

std::filesystem::path write(const sample::TemporaryDirectory& directory, const std::string& text) {
  const std::filesystem::path file = directory.path() / "catalogue.csv";
  std::ofstream(file) << text;
  return file;
}

std::string cell(std::string_view column, const SeismicEvent& event, const CatalogueContext& context) {
  for (const EventColumn& candidate : event_columns())
    if (candidate.text_name() == column) return cell_text(candidate, event, context);
  FAIL("no column " << column);
  return {};
}

}  // namespace

TEST_CASE("a catalogue in CSV gives every bit of every event back", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "catalogue.csv";
  const std::vector<SeismicEvent> events = sample::random_events(500, 1);
  // A place on Earth has no meaning for events that lie anywhere between 1e-300 m and 1e300 m.
  const CatalogueContext context = sample::context_without_place();
  CatalogueCsv csv(file);
  csv.append(events, context);
  csv.sync();
  const std::vector<SeismicEvent> back = read_catalogue_csv(file);
  REQUIRE(back.size() == events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    INFO(csv_line(events[i], context));
    CHECK(sample::same_bits(back[i], events[i]));
  }
}

TEST_CASE("angles stand in degrees, with no more digits than they need", "[seismicity][catalogue]") {
  constexpr double pi = std::numbers::pi;
  CHECK(degrees_text(pi / 2) == "90");
  CHECK(degrees_text(pi) == "180");
  // The doubles nearest to these angles.
  CHECK(degrees_text(-0x1.0c152382d7366p-1) == "-30");
  CHECK(degrees_text(0x1.709d10d3e7eacp+2) == "330");
  CHECK(degrees_text(0) == "0");
}

TEST_CASE("the line that a run is still writing is no event", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const CatalogueContext context = sample::context_without_place();
  const SeismicEvent event = sample::random_events(1, 2).front();
  const std::string line = csv_line(event, context);
  const auto file = write(directory, csv_header() + line + line.substr(0, line.size() - 1));
  CHECK(read_catalogue_csv(file).size() == 1);
}

TEST_CASE("a damaged catalogue is refused with its line", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const CatalogueContext context = sample::context_without_place();
  const std::string line = csv_line(sample::random_events(1, 3).front(), context);
  const auto message = [&](const std::string& text) {
    try {
      read_catalogue_csv(write(directory, text));
    } catch (const InputError& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  CHECK_THAT(message(csv_header() + line + "1,2\n"), Contains("line 3") && Contains("2 cells"));
  std::string other = csv_header();
  other.replace(other.find("t0_s"), 4, "time");
  CHECK_THAT(message(other + line), Contains("t0_s"));
  std::string wrong = csv_line(SeismicEvent{}, context);
  wrong.replace(wrong.find("mixed"), 5, "other");
  CHECK_THAT(message(csv_header() + wrong), Contains("line 2") && Contains("other"));
  std::string infinite = csv_line(SeismicEvent{}, context);
  infinite.replace(2, 1, "inf");
  CHECK_THAT(message(csv_header() + infinite), Contains("line 2") && Contains("inf"));
  CHECK_THAT(message(""), Contains("catalogue.csv"));
}

TEST_CASE("columns may come in another order, with others between them", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const CatalogueContext context = sample::context_without_place();
  const SeismicEvent event = sample::random_events(1, 4).front();
  std::string header, line;
  const auto& columns = event_columns();
  for (auto column = columns.rbegin(); column != columns.rend(); ++column) {
    header += column->text_name() + ",remark,";
    line += cell_text(*column, event, context) + ",any text,";
  }
  header.back() = line.back() = '\n';
  const std::vector<SeismicEvent> back = read_catalogue_csv(write(directory, header + line));
  REQUIRE(back.size() == 1);
  CHECK(sample::same_bits(back.front(), event));
}

TEST_CASE("what there is not leaves its cell empty", "[seismicity][catalogue]") {
  const SeismicEvent event;
  for (const char* column : {"utc", "lat", "lon", "depth_m", "Mw"})
    CHECK(cell(column, event, sample::context_without_place()).empty());
  for (const char* column : {"utc", "lat", "lon", "depth_m"})
    CHECK_FALSE(cell(column, event, sample::placed_context()).empty());
}

TEST_CASE("a cell of time and place is that of the event", "[seismicity][catalogue]") {
  SeismicEvent event;
  event.origin_time = 61.5;
  const CatalogueContext context = sample::placed_context();
  CHECK(cell("utc", event, context) == "2026-02-01T00:00:01.750000Z");
  CHECK(cell("lat", event, context) == "56.7");
  CHECK(cell("lon", event, context) == "-120.5");
  CHECK(cell("depth_m", event, context) == "2500");
  CHECK(cell("z_m", event, context) == "0");
}
