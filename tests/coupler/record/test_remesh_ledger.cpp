// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "coupler/record/remesh_ledger.hpp"
#include "tests/coupler/record/sample_run.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

nlohmann::json entry(std::uint64_t removed, std::uint64_t made) {
  return {{"fracture", "slit"},
          {"x", 1.5},
          {"y", -0.25},
          {"elements_removed", removed},
          {"elements_made", made},
          {"elements_untouched", 1000},
          {"hash_before", "ab12"},
          {"hash_after", "ab12"},
          {"smallest_angle", 0.5},
          {"smallest_altitude", 0.2},
          {"stable_step_before", 4e-5},
          {"stable_step_after", 3e-5},
          {"strain_energy_before", 10.0},
          {"strain_energy_after", 10.5},
          {"kinetic_energy_before", 2.0},
          {"kinetic_energy_after", 2.0},
          {"mass_error", -3e-16},
          {"momentum_error", 1e-15},
          {"wall_seconds", 0.002}};
}

}  // namespace

TEST_CASE("a run whose mesh never changed has no remeshing.csv", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  RemeshLedger ledger(folder.path());
  ledger.flush();
  CHECK_FALSE(std::filesystem::exists(folder.path() / "remeshing.csv"));
  CHECK(ledger.totals().insertions == 0);
  CHECK(ledger.totals().untouched_identical);
}

TEST_CASE("remeshing.csv has one line for each inserted segment, as the structure told it",
          "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  RemeshLedger ledger(folder.path());
  ledger.add(7, 2.5, remeshing_from_json(entry(20, 26)));
  nlohmann::json odd = entry(30, 24);
  odd["fracture"] = "the \"north, old\" one";
  ledger.add(8, 2.75, remeshing_from_json(odd));
  ledger.flush();
  const auto lines = sample::lines(folder.path() / "remeshing.csv");
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].starts_with("revision,time,fracture,x,y,elements_removed,"));
  CHECK(lines[1] == "7,2.5,slit,1.5,-0.25,20,26,1000,ab12,ab12,0.5,0.2,4e-05,3e-05,10,10.5,2,2,-3e-16,1e-15");
  CHECK(sample::lines(folder.path() / "remeshing_wall.csv") ==
        std::vector<std::string>{"revision,wall_seconds", "7,0.002", "8,0.002"});
  CHECK(lines[2].starts_with("8,2.75,\"the \"\"north, old\"\" one\",1.5,"));
}

TEST_CASE("the totals of remeshing are the worst of every kind", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  RemeshLedger ledger(folder.path());
  ledger.add(1, 1, remeshing_from_json(entry(20, 26)));
  nlohmann::json second = entry(40, 24);
  second["smallest_angle"] = 0.4;
  second["mass_error"] = -5e-15;
  second["stable_step_after"] = 5e-5;
  ledger.add(2, 2, remeshing_from_json(second));
  CHECK(ledger.totals().median_touched == 33);  // between 26 and 40
  ledger.add(3, 3, remeshing_from_json(entry(10, 10)));

  const RemeshTotals totals = ledger.totals();
  CHECK(totals.insertions == 3);
  CHECK(totals.median_touched == 26);
  CHECK(totals.largest_touched == 40);
  CHECK(totals.untouched_identical);
  CHECK(totals.smallest_angle == 0.4);
  CHECK(totals.largest_mass_error == 5e-15);
  CHECK(totals.smallest_step_ratio == 0.75);
  CHECK(totals.strain_energy_jump == 1.5);
  CHECK(totals.wall == Approx(0.006));
}

TEST_CASE("segments inserted at once share one jump of the strain energy", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  RemeshLedger ledger(folder.path());
  ledger.add(1, 1, remeshing_from_json(entry(20, 26)));
  ledger.add(1, 1, remeshing_from_json(entry(30, 24)));
  CHECK(ledger.totals().strain_energy_jump == 0.5);
  ledger.add(2, 2, remeshing_from_json(entry(30, 24)));
  CHECK(ledger.totals().strain_energy_jump == 1.0);
}

TEST_CASE("one hash that differs is never forgotten", "[coupler][record]") {
  const sample::TemporaryDirectory folder;
  RemeshLedger ledger(folder.path());
  nlohmann::json changed = entry(20, 26);
  changed["hash_after"] = "ab13";
  ledger.add(1, 1, remeshing_from_json(changed));
  ledger.add(2, 2, remeshing_from_json(entry(20, 26)));
  CHECK_FALSE(ledger.totals().untouched_identical);
}

TEST_CASE("an entry of the remesh ledger with a missing key breaks the protocol", "[coupler][record]") {
  nlohmann::json broken = entry(20, 26);
  SECTION("missing") {
    broken.erase("mass_error");
    CHECK_THROWS_WITH(remeshing_from_json(broken), Catch::Contains("mass_error"));
  }
  SECTION("of another type") {
    broken["elements_made"] = "many";
  }
  CHECK_THROWS_AS(remeshing_from_json(broken), ProtocolError);
}
