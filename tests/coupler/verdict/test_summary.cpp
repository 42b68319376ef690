// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <limits>

#include "coupler/verdict/summary.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

History two_intervals() {
  History history;
  IntervalRecord record;
  record.time = 1;
  record.explicit_steps = 10;
  record.mismatch = 3e-3;
  record.ledger = {1, 2, 0, 3, 4, 5, 6, 1e-12};
  history.add(record);
  record.time = 4;
  record.explicit_steps = 20;
  record.mismatch = 1e-3;
  record.natural_fractures = {2.5e-4, 6, 1.25, 7, 1.5, 8e-6};
  record.junction_pressure = 11e6;
  record.ledger = {10, 2, 0.5, 8, 4, 0, 0, 1e-15};
  history.add(record);
  return history;
}

}  // namespace

TEST_CASE("the summary has the keys that scripts rely on", "[coupler][verdict]") {
  Verdict verdict;
  verdict.judgement = Judgement::pass;
  verdict.quantities = {{"half_length", Measure::value_at, "m", 12.5, 12.625, 0.01, 0.02, true, ""},
                        {"relative_residual", Measure::maximum, "1", 1e-10, 3e-16, {}, {}, true, ""}};
  RunFigures figures;
  figures.wall = {10, 9, 7, 1, 0.6, 0.3, 0.02, 0.1};
  figures.seismicity = {{"events", 12}};
  figures.elements = 7000;
  figures.nodes = 3600;
  figures.insertions = 3;
  figures.remeshing = {3, 26, 40, true, 0.5, 0.006, 5e-15, 1e-15, 0.75, 1.5};
  figures.meetings = {3, 2};
  const auto summary = summary_json(verdict, two_intervals(), figures);

  CHECK(summary["verdict"] == "pass");
  const auto& first = summary["quantities"][0];
  CHECK(first["name"] == "half_length");
  CHECK(first["unit"] == "m");
  CHECK(first["expected"] == 12.5);
  CHECK(first["obtained"] == 12.625);
  CHECK(first["relative_error"] == 0.01);
  CHECK(first["tolerance"] == 0.02);
  CHECK(first["pass"] == true);
  CHECK(summary["quantities"][1]["relative_error"].is_null());
  CHECK(summary["ledger"]["injected"] == 10);
  CHECK(summary["ledger"]["in_fractures"] == 8);
  CHECK(summary["ledger"]["found"] == 0.5);
  CHECK(summary["ledger"]["leaked"] == 4);
  CHECK(summary["ledger"]["max_relative_residual"] == 1e-12);
  // One second of 3e-3 and three of 1e-3.
  CHECK(summary["mismatch"]["mean"].get<double>() == Approx(1.5e-3).epsilon(1e-14));
  CHECK(summary["mismatch"]["max"] == 3e-3);
  CHECK(summary["coupling"]["intervals"] == 2);
  CHECK(summary["coupling"]["explicit_steps"] == 30);
  CHECK(summary["coupling"]["insertions"] == 3);
  CHECK(summary["remeshing"]["insertions"] == 3);
  CHECK(summary["remeshing"]["median_touched"] == 26);
  CHECK(summary["remeshing"]["largest_touched"] == 40);
  CHECK(summary["remeshing"]["untouched_identical"] == true);
  CHECK(summary["remeshing"]["smallest_angle"] == 0.5);
  CHECK(summary["remeshing"]["wall_s"] == 0.006);
  CHECK(summary["remeshing"]["largest_mass_error"] == 5e-15);
  const auto& natural = summary["natural_fractures"];
  CHECK(natural["met"] == 3);
  CHECK(natural["crossed"] == 2);
  CHECK(natural["arrested"] == 1);
  CHECK(natural["wetted_length"] == 7);
  CHECK(natural["slipped_length"] == 6);
  CHECK(natural["opened_length"] == 1.25);
  CHECK(natural["greatest_slip"] == 2.5e-4);
  CHECK(natural["slip_distance"] == 1.5);
  CHECK(natural["greatest_far_slip"] == 8e-6);
  CHECK(natural["greatest_junction_pressure"] == 11e6);
  CHECK(natural["found"] == 0.5);
  CHECK(summary["seismicity"]["events"] == 12);
  CHECK(summary["wall"]["seismicity_s"] == 0.02);
  CHECK(summary["wall"]["total_s"] == 10);
  CHECK(summary["wall"]["structure_s"] == 9);
  CHECK(summary["wall"]["element_s"] == 7);
  CHECK(summary["wall"]["joint_s"] == 1);
  CHECK(summary["wall"]["network_s"] == 0.6);
  CHECK(summary["wall"]["coupler_s"] == 0.3);
  CHECK(summary["wall"]["waiting_s"] == 0.1);
  CHECK(summary["wall"]["structure_loops_share"].get<double>() == Approx(0.8));
  CHECK(summary["mesh"]["elements"] == 7000);
  CHECK(summary["mesh"]["nodes"] == 3600);
  CHECK_FALSE(summary.contains("failure"));
}

TEST_CASE("a run that broke down has failed, whatever its quantities say", "[coupler][verdict]") {
  Verdict verdict;
  verdict.judgement = Judgement::pass;
  RunFigures figures;
  figures.failure = Failure{ExitCode::participant_died, "network", 17, "advance", "network died of signal 9"};
  const auto summary = summary_json(verdict, History(), figures);
  CHECK(summary["verdict"] == "fail");
  CHECK(summary["failure"]["exit_code"] == 20);
  CHECK(summary["failure"]["code"] == "PARTICIPANT-DIED");
  CHECK(summary["failure"]["participant"] == "network");
  CHECK(summary["failure"]["interval"] == 17);
  CHECK(summary["failure"]["phase"] == "advance");
  CHECK(summary["failure"]["sentence"] == "network died of signal 9");
}

TEST_CASE("a residual that is not a number is not hidden behind the others", "[coupler][verdict]") {
  History history = two_intervals();
  IntervalRecord record;
  record.time = 5;
  record.ledger.relative_residual = std::numeric_limits<double>::quiet_NaN();
  history.add(record);
  const auto residual = summary_json({}, history, {})["ledger"]["max_relative_residual"].get<double>();
  CHECK(residual != residual);
}
