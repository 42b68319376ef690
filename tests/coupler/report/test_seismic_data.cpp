// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>

#include "common/case/case_json.hpp"
#include "common/errors.hpp"
#include "coupler/report/report_data.hpp"
#include "coupler/report/seismic_data.hpp"
#include "coupler/report/seismic_events.hpp"
#include "coupler/seismicity/catalogue/catalogue_csv.hpp"
#include "coupler/seismicity/catalogue/controls_text.hpp"
#include "tests/coupler/record/sample_run.hpp"
#include "tests/coupler/report/small_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

Case pumped_shale() {
  Case value;
  value.time.end = 1;
  value.domain = {4, 2, 10};
  value.mesh.tip_size = 1;
  value.rock = {2400, 32e9, 0.2, 1e6, 50, 1, 0.6};
  value.injection.perforations = {{"p", {0, 0}, 1e-5}};
  Stage stage;
  stage.rate = 0.01;
  stage.fluid = "water";
  value.injection.stages = {stage};
  value.fluids = {{"water", 1e-3, 1, 2e9}};
  return value;
}

SeismicEvent event_of(std::uint64_t id, double time, double moment) {
  SeismicEvent event;
  event.id = id;
  event.origin_time = time - 0.01;
  event.centroid_time = time;
  event.centroid = {3 * time, 4 * time};
  event.moment = {0, 0, 0, moment};
  event.scalar_moment = moment;
  event.scalar_sum = 2 * moment;
  event.magnitude = moment_magnitude(moment);
  event.shares = {0, 0, 1};
  event.type = EventType::shear;
  event.normal = {0, 1};
  event.slip = 1.23456789e-4;
  event.thickness = 10;
  event.fracture = SourceFracture::natural;
  return event;
}

/// The small run with a case that is whole, and with a catalogue.
class SeismicRun {
 public:
  explicit SeismicRun(const std::vector<SeismicEvent>& events) : run_(folder_.path() / "run") {
    small_run::write_with_natural_fracture(run_);
    std::ofstream(run_ / "effective_case.json") << case_to_json(pumped_shale());
    std::filesystem::create_directory(run_ / "seismicity");
    CatalogueContext context{"0123", "sample", "", extraction_controls(pumped_shale()), {}};
    CatalogueCsv file(run_ / "seismicity" / "catalogue.csv");
    file.append(events, context);
    file.sync();
  }
  [[nodiscard]] const std::filesystem::path& path() const { return run_; }
  [[nodiscard]] nlohmann::json data() const {
    return nlohmann::json::parse(report_data(run_)["seismicity"].dump());
  }

 private:
  sample::TemporaryDirectory folder_;
  std::filesystem::path run_;
};

}  // namespace

TEST_CASE("a run without a catalogue, or with none in it yet, has no seismic data", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  CHECK(report_data(folder.path() / "run")["seismicity"].is_null());
  CHECK(SeismicRun({}).data().is_null());
}

TEST_CASE("the catalogue in a report: columns of the events, sums of the run, and slip beside them",
          "[coupler][report]") {
  const SeismicRun run({event_of(1, 0.25, 1e6), event_of(2, 0.75, 4e6)});
  const nlohmann::json data = run.data();
  CHECK(data["columns"]["id"] == nlohmann::json({1, 2}));
  CHECK(data["columns"]["t0"] == nlohmann::json({0.24, 0.74}));
  CHECK(data["columns"]["tc"] == nlohmann::json({0.25, 0.75}));
  CHECK(data["columns"]["M0"] == nlohmann::json({1e6, 4e6}));
  CHECK(data["columns"]["Mxy"] == nlohmann::json({1e6, 4e6}));
  CHECK(data["columns"]["slip"][0] == 1.2346e-4);
  CHECK(data["columns"]["type"] == nlohmann::json({"shear", "shear"}));
  CHECK(data["columns"]["fracture"] == nlohmann::json({"natural", "natural"}));
  for (const char* name : {"x", "y", "Mw", "Mxx", "Myy", "Mzz", "iso", "clvd", "dc", "u", "v", "nx", "ny",
                           "length", "radius", "opening", "duration"})
    CHECK(data["columns"][name].size() == 2);
  CHECK(data["shown"] == nlohmann::json({{"events", 2}, {"of", 2}}));
  CHECK(data["totals"]["events"] == 2);
  CHECK(data["totals"]["seismic_sum"] == 1e7);
  CHECK(data["totals"]["event_moment"] == 5e6);
  CHECK(data["frequency_magnitude"]["numerical_floor"].get<double>() == Approx(-1.11602).epsilon(5e-6));
  CHECK_FALSE(data["frequency_magnitude"]["not_reported"].is_null());
  CHECK(data["distance"]["time"] == nlohmann::json({0.25, 0.75}));
  CHECK(data["distance"]["distance"] == nlohmann::json({1.25, 3.75}));
  CHECK(data["distance"]["laws"].size() == 3);
  CHECK(data["pumping"]["time"] == nlohmann::json({0.5, 1.0}));
  CHECK(data["moment"]["time"] == nlohmann::json({0, 0.25, 0.5, 0.75, 1.0}));
  CHECK(data["moment"]["cumulative"] == nlohmann::json({0, 1e6, 1e6, 5e6, 5e6}));
  CHECK(data["rate"]["time"].size() == 21);
  CHECK(data["volume"]["thickness"] == 10);
  // At the report of time 1: the unit at (2, 0) that slipped, and those beside it.
  REQUIRE(data["slip"]["time"] == 1.0);
  const auto joints = report_data(run.path())["joints"];
  CHECK(data["slip"]["segments"].size() == joints["reports"].back()["unit"].size());
  bool is_there = false;
  for (const nlohmann::json& segment : data["slip"]["segments"]) {
    CHECK(segment[0].get<double>() == Approx(2));  // the fracture runs along x = 2
    CHECK(segment[2].get<double>() == Approx(2));
    CHECK(std::abs(segment[3].get<double>() - segment[1].get<double>()) > 0.1);
    is_there = is_there || segment[4] == 2.5e-4;
  }
  CHECK(is_there);
  CHECK_THAT(data["caption"].get<std::string>(), Catch::Contains("slip is seismic from 0.001 m/s"));
}

TEST_CASE("once a run has ended the sums and thresholds of its catalogue are shown", "[coupler][report]") {
  const SeismicRun run({event_of(1, 0.25, 1e6)});
  nlohmann::json summary;
  summary["sums"] = {{"raw", {1, 2, 3, 4}},
                     {"aseismic", {1, 1, 1, 1}},
                     {"event_moment", 1e6},
                     {"seismic_sum", 2e6},
                     {"aseismic_sum", 6e6}};
  for (const Control& control : controls_of(extraction_controls(pumped_shale())))
    summary["parameters"][std::string(control.name)] = control.value;
  summary["parameters"]["cluster_radius"] = 7.5;
  summary["parameters"]["thickness_equidimensional"] = 1;
  std::ofstream(run.path() / "seismicity" / "summary.json") << summary;
  const nlohmann::json data = run.data();
  CHECK(data["totals"]["raw"] == nlohmann::json({1, 2, 3, 4}));
  CHECK(data["totals"]["seismic_fraction"] == 0.25);
  CHECK_THAT(data["caption"].get<std::string>(),
             Catch::Contains("within 7.5 m") && Catch::Contains("as much as its length"));
  std::ofstream(run.path() / "seismicity" / "summary.json") << "{}";
  CHECK_THROWS_AS(report_data(run.path()), InputError);
}

TEST_CASE("a dry run has events but no distance from a well", "[coupler][report]") {
  const SeismicRun run({event_of(1, 0.25, 1e6)});
  Case dry = pumped_shale();
  dry.injection = {};
  const nlohmann::json data =
      seismic_data(run.path(), case_to_json(dry), CsvColumns(run.path() / "history.csv"), nullptr);
  CHECK(data["distance"].is_null());
  CHECK(data["slip"].is_null());
  CHECK(data["columns"]["id"].size() == 1);
}

TEST_CASE("a large catalogue is thinned: the greatest events stay, the rest is spread evenly",
          "[coupler][report]") {
  std::vector<SeismicEvent> events;
  for (std::uint64_t id = 1; id <= 1000; ++id)
    events.push_back(event_of(id, static_cast<double>(id), id % 50 == 7 ? 1e9 + double(id) : 1e5));
  const std::vector<std::size_t> shown = events_to_draw(events, 100);
  CHECK(shown.size() == 100);
  CHECK(std::set<std::size_t>(shown.begin(), shown.end()).size() == 100);
  CHECK(std::is_sorted(shown.begin(), shown.end()));
  for (std::size_t number = 6; number < 1000; number += 50)
    CHECK(std::binary_search(shown.begin(), shown.end(), number));
  CHECK(shown.back() == 999);
  CHECK(events_to_draw(events, 1000).size() == 1000);
  CHECK(events_to_draw({}, 100).empty());
}
