// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include "common/natural_fractures/clean_traces.hpp"
#include "common/natural_fractures/natural_network.hpp"

using namespace fissura;

namespace {

constexpr double h = 2;  // natural_size of the cases below [m]

/// A square of 200 m with a slit from (0, -5) to (0, 5) m, perforated in its middle.
Case square() {
  Case given;
  given.domain = {200, 200, 1};
  given.mesh.fracture_size = 0.5;
  given.mesh.natural_size = h;
  given.mesh.far_size = 10;
  FractureLine slit;
  slit.name = "slit";
  slit.points = {{0, -5}, {0, 5}};
  given.fractures = {slit};
  given.injection.perforations = {{"hole", {0, 0}, 1e-5}};
  return given;
}

Trace trace(const std::string& name, Point begin, Point end) {
  return {"set", name, {begin, end}};
}

std::vector<std::string> words(const CleanedTraces& cleaned) {
  std::vector<std::string> result;
  for (const CleaningRecord& record : cleaned.records)
    result.push_back(record.trace + " " + name(record.action));
  return result;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("traces that cross, touch or stay clear are left alone", "[common][natural]") {
  const CleanedTraces cleaned = clean_traces(
      {trace("a", {20, -20}, {20, 20}), trace("b", {10, 0}, {30, 5}), trace("c", {20, 10}, {40, 10}),
       trace("d", {25, -15}, {45, -15}), trace("e", {-10, 1}, {10, 3})},
      square());
  CHECK(words(cleaned) == Words{});
  CHECK(cleaned.traces.size() == 5);
  CHECK(cleaned.traces[4].segment.end == Point{10, 3});
}

TEST_CASE("an end near another line is brought onto it or taken back, whichever is less",
          "[common][natural]") {
  SECTION("short of it") {
    const CleanedTraces cleaned =
        clean_traces({trace("a", {20, -20}, {20, 20}), trace("b", {40, 0}, {20.3, 0})}, square());
    REQUIRE(words(cleaned) == Words{"b extended"});
    CHECK(cleaned.records[0].amount == Approx(0.3));
    CHECK(cleaned.records[0].at == Point{20.3, 0});
    CHECK_THAT(cleaned.records[0].cause, Catch::Contains("within 0.3 m of 'a'"));
    CHECK(cleaned.traces[1].segment.end[0] == Approx(20).epsilon(1e-14));
  }
  SECTION("beyond it") {
    const CleanedTraces cleaned =
        clean_traces({trace("a", {20, -20}, {20, 20}), trace("b", {40, 0}, {19.8, 0})}, square());
    REQUIRE(words(cleaned) == Words{"b shortened"});
    CHECK(cleaned.traces[1].segment.end[0] == Approx(20).epsilon(1e-14));
  }
  SECTION("nearly clear of it") {
    const CleanedTraces cleaned =
        clean_traces({trace("a", {20, -20}, {20, 20}), trace("b", {40, 0}, {20.9, 0})}, square());
    REQUIRE(words(cleaned) == Words{"b shortened"});
    CHECK(cleaned.traces[1].segment.end[0] == Approx(20 + h / 2).epsilon(1e-3));
  }
}

TEST_CASE("a trace that passes near an end of an earlier one moves aside and keeps its length",
          "[common][natural]") {
  const CleanedTraces cleaned = clean_traces(
      {trace("a", {20, 0.4}, {20, 30}), trace("b", {0.4, 60}, {40, 60}), trace("c", {5, 0}, {45, 0})},
      square());
  REQUIRE(words(cleaned) == Words{"c moved"});
  CHECK(cleaned.records[0].amount < h);
  CHECK(length(cleaned.traces[2].segment) == Approx(40).epsilon(1e-12));
}

TEST_CASE("of two traces at a small angle the later one loses the stretch near the crossing",
          "[common][natural]") {
  const double rise = 30 * std::tan(4 * std::numbers::pi / 180);
  const CleanedTraces cleaned = clean_traces(
      {trace("a", {20, 30}, {80, 30}), trace("b", {20, 30 - rise / 3}, {80, 30 + 5 * rise / 3})}, square());
  REQUIRE(words(cleaned) == Words{"b shortened"});
  CHECK_THAT(cleaned.records[0].cause, Catch::Contains("meets 'a' at 4 degrees"));
  CHECK(distance(cleaned.traces[0].segment, cleaned.traces[1].segment) >= h / 2);
}

TEST_CASE("duplicates and overlaps: the later trace goes, or keeps what lies free", "[common][natural]") {
  SECTION("the same once more, and backwards") {
    const CleanedTraces cleaned = clean_traces(
        {trace("a", {20, 30}, {80, 30}), trace("b", {20, 30}, {80, 30}), trace("c", {80, 30}, {20, 30})},
        square());
    CHECK(words(cleaned) == Words{"b removed", "c removed"});
    CHECK_THAT(cleaned.records[0].cause, Catch::Contains("lies on 'a'"));
  }
  SECTION("in part") {
    const CleanedTraces cleaned =
        clean_traces({trace("a", {20, 30}, {60, 30}), trace("b", {50, 30}, {90, 30})}, square());
    REQUIRE(cleaned.traces.size() == 2);
    CHECK(words(cleaned) == Words{"b shortened"});
    CHECK(cleaned.traces[1].segment.begin[0] == Approx(60).margin(1.01 * h / 2));
  }
  SECTION("beside it") {
    const CleanedTraces cleaned =
        clean_traces({trace("a", {20, 30}, {80, 30}), trace("b", {20, 30.2}, {80, 30.2})}, square());
    CHECK(words(cleaned) == Words{"b removed"});
  }
}

TEST_CASE("traces without length, shorter than two edges or outside the domain are removed",
          "[common][natural]") {
  const CleanedTraces cleaned =
      clean_traces({trace("a", {20, 30}, {20, 30}), trace("b", {20, 30}, {20 + 1.9 * h, 30}),
                    trace("c", {150, 0}, {200, 0}), trace("d", {100, -50}, {100, 50}),
                    trace("e", {99.5, -50}, {99.5, 50})},
                   square());
  CHECK(cleaned.traces.empty());
  CHECK(words(cleaned) == Words{"a removed", "b removed", "c removed", "d removed", "e removed"});
}

TEST_CASE("a trace that leaves the domain is cut inside it", "[common][natural]") {
  const CleanedTraces cleaned = clean_traces({trace("a", {50, 0}, {150, 0})}, square());
  REQUIRE(words(cleaned) == Words{"a kept inside"});
  CHECK(cleaned.records[0].amount == Approx(50 + h));
  CHECK(cleaned.traces[0].segment.end[0] == Approx(100 - h));
}

TEST_CASE("a trace near the slit or across its perforation gives way", "[common][natural]") {
  SECTION("past the end of the slit") {
    const CleanedTraces cleaned = clean_traces({trace("a", {-20, 5.1}, {20, 5.1})}, square());
    REQUIRE(cleaned.traces.size() == 1);
    CHECK(words(cleaned) == Words{"a moved"});
  }
  SECTION("through the slit, just beside the perforation") {
    const CleanedTraces cleaned = clean_traces({trace("a", {-20, 0.1}, {20, 0.1})}, square());
    REQUIRE(cleaned.traces.size() == 1);
    CHECK(words(cleaned) == Words{"a moved"});
  }
  SECTION("intact rock that fractures do not follow is in nobody's way") {
    Case given = square();
    given.fractures[0].kind = FractureKind::intact;
    given.growth.path = PathRule::free;
    CHECK(words(clean_traces({trace("a", {-20, 5.1}, {20, 5.1})}, given)) == Words{});
  }
}

TEST_CASE("cleaning a cleaned network changes nothing", "[common][natural]") {
  std::mt19937_64 random(11);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Trace> traces;
  for (int i = 0; i < 150; ++i) {
    const double x = 200 * uniform() - 100, y = 200 * uniform() - 100, angle = 7 * uniform(),
                 half = 5 + 20 * uniform();
    traces.push_back(trace(std::to_string(i), {x - half * std::cos(angle), y - half * std::sin(angle)},
                           {x + half * std::cos(angle), y + half * std::sin(angle)}));
  }
  const Case given = square();
  const CleanedTraces once = clean_traces(traces, given);
  CHECK(once.records.size() > 20);
  CHECK(once.traces.size() > 50);
  const CleanedTraces twice = clean_traces(once.traces, given);
  CHECK(words(twice) == Words{});
  REQUIRE(twice.traces.size() == once.traces.size());
  for (std::size_t i = 0; i < once.traces.size(); ++i)
    CHECK(twice.traces[i].segment.begin == once.traces[i].segment.begin);
}

TEST_CASE("traces become natural fractures with the faces of their set, in order of name",
          "[common][natural]") {
  Case given = square();
  NaturalFractureSet set;
  set.name = "joints";
  set.orientation = {0.3, 0.05};
  set.spacing = {20, 2};
  set.length = {15, 1};
  set.persistence = {30, 3};
  set.west = set.south = -100;
  set.east = set.north = 100;
  set.faces.friction_coefficient = 0.4;
  set.faces.joint_compliance = 3e-11;
  given.natural_fracture_sets = {set};
  FractureLine single;
  single.name = "fault";
  single.friction_coefficient = 0.2;
  single.points = {{30, 30}, {40, 45}};
  const NaturalFractureReport report = add_natural_fractures(given, std::vector<FractureLine>{single});
  REQUIRE(given.fractures.size() == 1 + report.kept);
  CHECK(given.fractures[1].name == "fault");
  CHECK(given.fractures[1].friction_coefficient == 0.2);
  CHECK(given.fractures[1].set.empty());
  CHECK(given.fractures[2].name == "joints 1");
  CHECK(given.fractures[2].set == "joints");
  CHECK(given.fractures[2].kind == FractureKind::natural);
  CHECK(given.fractures[2].friction_coefficient == 0.4);
  CHECK(given.fractures[2].joint_compliance == 3e-11);
  REQUIRE(report.sets.size() == 1);
  CHECK(report.sets[0].cleaned_traces == report.kept - 1);
  std::size_t removed = 0;
  for (const CleaningRecord& record : report.cleaning)
    removed += record.action == CleaningAction::removed ? 1 : 0;
  CHECK(report.kept + removed == report.given + report.drawn);
}
