// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>

#include "common/errors.hpp"
#include "coupler/record/hdf5_file.hpp"
#include "coupler/record/segments.hpp"
#include "coupler/seismicity/catalogue/catalogue.hpp"
#include "coupler/seismicity/catalogue/catalogue_hdf5.hpp"
#include "coupler/seismicity/catalogue/catalogue_points.hpp"
#include "coupler/seismicity/catalogue/quakeml.hpp"
#include "coupler/seismicity/catalogue/raw_records.hpp"
#include "tests/coupler/seismicity/catalogue/sample_events.hpp"

using namespace fissura;
using namespace fissura::coupler;
using Catch::Matchers::Contains;

namespace {

/// Events that fit together, and what they came from.
struct Extracted {
  std::vector<SeismicEvent> events;
  SeismicSums sums;
};

Extracted extracted(std::size_t count, const CatalogueContext& context) {
  Extraction extraction(context.controls);
  Extracted result;
  result.events = extraction.advance(1e6, sample::random_sources(count, 5));
  const std::vector<SeismicEvent> last = extraction.finish();
  result.events.insert(result.events.end(), last.begin(), last.end());
  result.sums = extraction.sums();
  return result;
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("a catalogue in HDF5 gives every bit of every event back", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "catalogue.h5";
  const std::vector<SeismicEvent> events = sample::random_events(500, 6);
  write_catalogue_hdf5(file, events, {}, sample::context_without_place());
  const std::vector<SeismicEvent> back = read_catalogue_hdf5(file);
  REQUIRE(back.size() == events.size());
  for (std::size_t i = 0; i < events.size(); ++i) CHECK(sample::same_bits(back[i], events[i]));

  write_catalogue_hdf5(file, {}, {}, sample::context_without_place());
  CHECK(read_catalogue_hdf5(file).empty());
}

TEST_CASE("columns of a catalogue in HDF5 say their unit", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "catalogue.h5";
  write_catalogue_hdf5(file, sample::random_events(3, 7), {}, sample::context_without_place());
  const Hdf5File catalogue = Hdf5File::open(file);
  CHECK(catalogue.read("/events/t0").unit == "s");
  CHECK(catalogue.read("/events/M0").unit == "N m");
  CHECK(catalogue.read("/events/strike").unit == "rad");
  CHECK(catalogue.read("/parameters/stress_drop").unit == "Pa");
  CHECK(catalogue.read_number("/", "schema") == 1);
}

TEST_CASE("a catalogue in HDF5 with a word that does not exist is refused", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "catalogue.h5";
  std::vector<SeismicEvent> events = sample::random_events(3, 8);
  events[1].type = static_cast<EventType>(9);
  write_catalogue_hdf5(file, events, {}, sample::context_without_place());
  CHECK_THROWS_WITH(read_catalogue_hdf5(file), Contains("type") && Contains("9"));
}

TEST_CASE("QuakeML without a georeference is refused with the keys that are missing",
          "[seismicity][catalogue]") {
  const CatalogueContext context = sample::context_without_place();
  try {
    (void)quakeml({}, context);
    FAIL("written without a place");
  } catch (const Error& fault) {
    CHECK(fault.code() == ExitCode::precondition);
    CHECK_THAT(fault.what(), Contains("[georeference]") && Contains("latitude") && Contains("longitude") &&
                                 Contains("depth") && Contains("start"));
  }
  CHECK_FALSE(possible_formats(context).contains(CatalogueFormat::quakeml));
  const sample::TemporaryDirectory directory;
  const std::filesystem::path folder = directory.path() / "catalogue";
  CHECK_THROWS_AS(write_catalogue(folder, {}, {}, context, nullptr, {{CatalogueFormat::quakeml}, {}}), Error);
  CHECK_FALSE(std::filesystem::exists(folder));
}

TEST_CASE("an event whose records cancel has a tensor but no magnitude in QuakeML",
          "[seismicity][catalogue]") {
  const CatalogueContext context = sample::placed_context();
  SeismicEvent event;
  event.id = 1;
  const std::string xml = quakeml({event}, context);
  CHECK(count_of(xml, "<event ") == 1);
  CHECK(count_of(xml, "<momentTensor ") == 1);
  for (const char* missing : {"<magnitude", "MagnitudeID>", "<nodalPlanes", "<principalAxes"})
    CHECK(count_of(xml, missing) == 0);
}

TEST_CASE("a catalogue that grew with its run is that written at once", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const CatalogueContext context = sample::placed_context();
  const Extracted made = extracted(300, context);
  REQUIRE(made.events.size() > 250);
  const nlohmann::ordered_json analysis{{"b", 1.5}};

  Catalogue grown(directory.path() / "grown", context);
  for (const SeismicEvent& event : made.events) {
    grown.append({event});
    grown.flush();
  }
  CHECK(read_catalogue_csv(directory.path() / "grown/catalogue.csv").size() == made.events.size());
  grown.finish(made.sums, analysis);
  write_catalogue(directory.path() / "whole", made.events, made.sums, context, analysis,
                  {possible_formats(context), std::nullopt});
  for (const char* name :
       {"catalogue.csv", "catalogue.h5", "catalogue.vtp", "catalogue.xml", "summary.json"}) {
    INFO(name);
    const std::string text = sample::content(directory.path() / "grown" / name);
    CHECK(text.size() > 100);
    CHECK(text == sample::content(directory.path() / "whole" / name));
  }
  const auto summary = nlohmann::json::parse(sample::content(directory.path() / "whole" / "summary.json"));
  CHECK(summary["analysis"]["b"] == 1.5);
  CHECK(summary["sums"]["events"] == made.events.size());
  CHECK(summary["conservation_error"].get<double>() < 1e-12);
}

TEST_CASE("small events are left out of points and QuakeML only", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const CatalogueContext context = sample::placed_context();
  const Extracted made = extracted(300, context);
  std::size_t greater = 0;
  for (const SeismicEvent& event : made.events) greater += event.magnitude && *event.magnitude >= -1;
  REQUIRE(greater > 0);
  REQUIRE(greater < made.events.size());
  write_catalogue(directory.path(), made.events, made.sums, context, nullptr,
                  {possible_formats(context), -1.0});
  CHECK(read_catalogue_csv(directory.path() / "catalogue.csv").size() == made.events.size());
  CHECK(read_catalogue_hdf5(directory.path() / "catalogue.h5").size() == made.events.size());
  CHECK(count_of(sample::content(directory.path() / "catalogue.xml"), "<event ") == greater);
  CHECK_THAT(sample::content(directory.path() / "catalogue.vtp"),
             Contains("NumberOfPoints=\"" + std::to_string(greater) + "\""));
}

TEST_CASE("nothing of an earlier catalogue stays beside a new one", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const CatalogueContext context = sample::placed_context();
  write_catalogue(directory.path(), {}, {}, context, nullptr, {possible_formats(context), {}});
  CHECK(std::filesystem::exists(directory.path() / "catalogue.xml"));
  write_catalogue(directory.path(), {}, {}, context, nullptr, {{CatalogueFormat::csv}, {}});
  for (const char* name : {"catalogue.h5", "catalogue.vtp", "catalogue.xml"})
    CHECK_FALSE(std::filesystem::exists(directory.path() / name));
  CHECK(std::filesystem::exists(directory.path() / "catalogue.csv"));
}

TEST_CASE("other thresholds give events other identifiers", "[seismicity][catalogue]") {
  CatalogueContext context = sample::placed_context();
  const std::string before = controls_id(context.controls);
  CHECK(before.size() == 12);
  context.controls.thresholds.cluster_radius = 3;
  CHECK(controls_id(context.controls) != before);
}

TEST_CASE("records in closed segments come back in their order", "[seismicity][catalogue]") {
  const sample::TemporaryDirectory directory;
  const std::vector<SourceRecord> records = sample::random_sources(30, 9);
  const auto part = [&](int begin, int end) {
    return std::vector<SourceRecord>(records.begin() + begin, records.begin() + end);
  };
  Segments segments(directory.path(), 2);
  segments.add_sources(1.5, part(0, 10));
  segments.add_sources(2.5, part(10, 12));
  segments.close();
  segments.add_sources(4, part(12, 29));
  segments.close();
  segments.add_sources(5, part(29, 30));  // never closed

  std::vector<SourceRecord> found;
  std::vector<double> times;
  const auto groups = for_each_source_group(directory.path(), [&](double time, const auto& list) {
    times.push_back(time);
    found.insert(found.end(), list.begin(), list.end());
  });
  CHECK(groups == 3);
  CHECK(times == std::vector<double>{1.5, 2.5, 4});
  CHECK(found == part(0, 29));

  const sample::TemporaryDirectory empty;
  CHECK_THROWS_AS(for_each_source_group(empty.path(), [](double, const auto&) {}), Error);
}
