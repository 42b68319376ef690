// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "common/errors.hpp"
#include "coupler/record/sealed_line.hpp"
#include "coupler/report/csv_columns.hpp"
#include "coupler/report/field_reports.hpp"
#include "coupler/report/report_data.hpp"
#include "coupler/report/stress_maps.hpp"
#include "coupler/seismicity/catalogue/raw_records.hpp"
#include "tests/coupler/record/sample_run.hpp"
#include "tests/coupler/report/small_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

TEST_CASE("the series of a report are the numbers of history.csv and ledger.csv", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  const nlohmann::json data = nlohmann::json::parse(report_data(folder.path() / "run").dump());
  for (const char* name : {"history", "ledger"}) {
    const CsvColumns file(folder.path() / "run" / (std::string(name) + ".csv"));
    CHECK(data[name]["rows"] == file.rows());
    for (const std::string& column : file.names()) {
      INFO(column);
      CHECK(data[name]["columns"][column].get<std::vector<double>>() == file.numbers(column));
    }
  }
}

TEST_CASE("the map holds every node once and the values of each report", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  const nlohmann::json map = report_data(folder.path() / "run")["map"];
  CHECK(map["nodes"]["x"] == nlohmann::json({-1.0, 0.0, 1.0, 2.0}));
  CHECK(map["segments"] == nlohmann::json({{0, 1, 0}, {1, 2, 0}, {2, 3, 1}}));
  REQUIRE(map["reports"].size() == 2);
  CHECK(map["reports"][0]["aperture"] == nlohmann::json({1e-4, 2e-4, 3e-4}));
  CHECK(map["reports"][1]["aperture"] == nlohmann::json({1e-4, 2e-4, 3e-4, 4e-4}));
  CHECK(map["reports"][1]["pressure"][3] == 4e6);
  CHECK(map["reports"][1]["time"] == 1.0);
}

TEST_CASE("stress and in-situ axes show where the rock is pressed most", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  const nlohmann::json data = report_data(folder.path() / "run");
  CHECK(data["in_situ"]["greatest"] == 15e6);
  CHECK(data["in_situ"]["least"] == 10e6);
  CHECK(std::abs(data["in_situ"]["angle"].get<double>()) < 1e-12);
  const nlohmann::json domain = data["stress"]["views"].back();
  CHECK(domain["x"].size() == 2);
  CHECK(domain["greatest"] == nlohmann::json({-15e6, -15e6}));
  CHECK(data["stress"]["time"] == 1.0);
}

TEST_CASE("the reference of the case is read from the run's own inputs", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::reference);
  const nlohmann::json comparison = report_data(folder.path() / "run")["comparison"];
  CHECK(comparison["remark"] == "");
  CHECK(comparison["curves"]["half_length"]["value"] == nlohmann::json({5.25, 6.5}));
  REQUIRE(comparison["points"].size() == 1);
  CHECK(comparison["points"][0]["value"] == 2e-3);
}

TEST_CASE("a run that is going on, or was killed, is shown as far as it went", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  const auto run = folder.path() / "run";
  small_run::write(run, small_run::Comparison::none);
  std::ofstream(run / "history.csv", std::ios::app) << "3,1,1.5,0.";
  std::ofstream(run / "segments" / "index.jsonl", std::ios::app) << "{\"file\":\"00";
  std::ofstream(run / "segments" / "000003.h5.part") << "half a file";
  nlohmann::json data = report_data(run);
  CHECK(data["summary"].is_null());
  CHECK(data["history"]["rows"] == 2);
  CHECK(data["map"]["reports"].size() == 2);

  SECTION("before the first interval and the first report") {
    std::filesystem::remove_all(run / "segments");
    const std::string header = sample::lines(run / "history.csv").front();
    std::ofstream(run / "history.csv") << header << "\n";
    data = report_data(run);
    CHECK(data["history"]["rows"] == 0);
    CHECK(data["stress"].is_null());
    CHECK(data["map"]["reports"].empty());
  }
}

TEST_CASE("the remesh ledger is taken as it stands", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  CHECK(report_data(folder.path() / "run")["remeshing"].is_null());
  std::ofstream(folder.path() / "run" / "remeshing.csv")
      << "revision,time,fracture,elements_removed,hash_before,hash_after\n1,0.5,\"slit, east\",12,0a,0a\n";
  std::ofstream(folder.path() / "run" / "remeshing_wall.csv") << "revision,wall_seconds\n1,0.25\n";
  const nlohmann::json remeshing = report_data(folder.path() / "run")["remeshing"];
  CHECK(remeshing["columns"]["wall_seconds"] == nlohmann::json({0.25}));
  CHECK(remeshing["rows"] == 1);
  CHECK(remeshing["columns"]["elements_removed"] == nlohmann::json({12.0}));
  CHECK(remeshing["columns"]["fracture"] == nlohmann::json({"slit, east"}));
}

TEST_CASE("another directory and a damaged segment are errors, not empty reports", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  CHECK_THROWS_WITH(report_data(folder.path()), Catch::Contains("is not a run directory"));
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  std::filesystem::resize_file(folder.path() / "run" / "segments" / "000002.h5", 100);
  CHECK_THROWS_AS(report_data(folder.path() / "run"), StorageError);
}

TEST_CASE("natural fractures are shown where anything has happened on them", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write_with_natural_fracture(folder.path() / "run");
  const nlohmann::json data = report_data(folder.path() / "run");
  const nlohmann::json& units = data["joints"]["units"];
  // The arms of the junction share their place: the lower one, of negative slip, reaches back, the upper one
  // ahead.
  CHECK(units["x"] == nlohmann::json({2.0, 2.0, 2.0}));
  CHECK(units["y"] == nlohmann::json({0.0, 0.0, 1.0}));
  CHECK(units["back"] == nlohmann::json({0.0, 0.5, 0.5}));
  CHECK(units["ahead"] == nlohmann::json({0.5, 0.0, 0.5}));
  // A right angle of five digits.
  CHECK(std::abs(std::sin(units["angle"][0].get<double>()) - 1) < 1e-5);
  REQUIRE(data["joints"]["reports"].size() == 1);
  const nlohmann::json& report = data["joints"]["reports"][0];
  CHECK(report["time"] == 1.0);
  CHECK(report["unit"] == nlohmann::json({0, 1, 2}));
  CHECK(report["slip"] == nlohmann::json({2.5e-4, -2e-4, 1e-5}));
  CHECK(report["wetted"] == nlohmann::json({1, 1, 0}));
  CHECK(report["open"] == nlohmann::json({1, 0, 0}));
  CHECK(data["map"]["kinds"] == nlohmann::json({0, 0, 0, 1}));
  CHECK(data["meetings"]["columns"]["natural"] == nlohmann::json({"nf"}));
  CHECK(data["meetings"]["columns"]["crosses"] == nlohmann::json({1.0}));
}

TEST_CASE("a run whose structure tells nothing of contact units is shown without them", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  const nlohmann::json data = report_data(folder.path() / "run");
  CHECK(data["joints"].is_null());
  CHECK(data["meetings"].is_null());
}

TEST_CASE("the maps of stress fill the fracture and the domain at every report", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  small_run::write(folder.path() / "run", small_run::Comparison::none);
  const nlohmann::json data = report_data(folder.path() / "run");
  const nlohmann::json &least = data["least_stress"], &relative = data["relative_stress"];
  REQUIRE(least["reports"].size() == 2);
  CHECK(relative["box"] == nlohmann::json({-2.0, 2.0, -1.0, 1.0}));
  // Stress as in situ, so that the ratio is 1 in the middle of its scale; -10 MPa is in the middle of the
  // other one.
  CHECK(relative["low"].get<double>() + relative["high"].get<double>() == Approx(2));
  CHECK(least["low"].get<double>() < -10e6);
  CHECK(least["high"].get<double>() > -10e6);
  // The network lies from -1 to 2 m on y = 0; no part of the rock is farther than 1.5 m from all of it.
  CHECK(relative["far"].is_null());
  const std::size_t cells = relative["columns"].get<std::size_t>() * relative["rows"].get<std::size_t>();
  CHECK(relative["reports"][1]["values"].get<std::string>().size() == (cells + 2) / 3 * 4);
}

TEST_CASE("the change of stress far away is that beyond half the extent of the network",
          "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 1);
  segments.add(1, small_run::structure_fields(), small_run::network_fields(network), network, {});
  FieldReports reports(folder.path());
  // The network lies from -1 to 1 m on y = 0, the rock is a square of 1 m above it, pressed 25 % more than in
  // situ.
  const View domain{"", -1, 1, -1, 1};
  const nlohmann::json in_situ{{"stress", {-12e6, -10e6, 0.0, -12e6}}};
  const nlohmann::json far = relative_stress_map(reports, in_situ, domain, {1, 400})["far"];
  CHECK(far["distance"] == 1.0);
  CHECK(far["greatest_change"].get<double>() == Approx(0.25));
}

TEST_CASE("a closed segment with a flipped bit is refused before HDF5 sees it", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  const FractureNetwork network = sample::network();
  Segments segments(folder.path(), 1);
  segments.add(1, small_run::structure_fields(), small_run::network_fields(network), network, {});
  segments.add_sources(2, {SourceRecord{}});
  segments.close();
  const std::filesystem::path first = folder.path() / "segments" / "000001.h5";
  const auto flip_middle = [](const std::filesystem::path& file) {
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    const auto middle = static_cast<std::streamoff>(std::filesystem::file_size(file) / 2);
    stream.seekg(middle);
    const int byte = stream.get();
    stream.seekp(middle);
    stream.put(static_cast<char>(byte ^ 4));
  };
  CHECK_NOTHROW(FieldReports(folder.path()));
  flip_middle(first);
  CHECK_THROWS_WITH(FieldReports(folder.path()),
                    Catch::Contains("000001.h5 is damaged: its SHA-256 is not that of index.jsonl"));
  CHECK_THROWS_AS(FieldReports(folder.path()), StorageError);
  flip_middle(folder.path() / "segments" / "000002.h5");
  CHECK_THROWS_WITH(for_each_source_group(folder.path(), [](double, const auto&) {}),
                    Catch::Contains("000002.h5 is damaged"));
}

TEST_CASE("an index of segments that is damaged is named", "[coupler][report]") {
  const sample::TemporaryDirectory folder;
  std::filesystem::create_directory(folder.path() / "segments");
  using Json = nlohmann::ordered_json;
  const Json whole{
      {"file", "000001.h5"}, {"meshes", {0}}, {"networks", {0}}, {"reports", {1, 2}}, {"sources", {1, 1}}};
  Json wrong = whole;
  wrong["reports"] = {true, 2};
  wrong["sources"] = "some";
  for (const std::string& line : {std::string("{\"file\": \"00"), std::string("[]"), whole.dump(),
                                  sealed_line({{"file", 3}}), sealed_line(wrong), sealed_line(whole)}) {
    std::ofstream(folder.path() / "segments" / "index.jsonl") << line << '\n';
    CHECK_THROWS_AS(FieldReports(folder.path()), StorageError);
    CHECK_THROWS_AS(for_each_source_group(folder.path(), [](double, const auto&) {}), Error);
  }
}
