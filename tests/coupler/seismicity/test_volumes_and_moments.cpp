// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "coupler/seismicity/analysis/analysis_json.hpp"
#include "coupler/seismicity/analysis/moment_budget.hpp"
#include "coupler/seismicity/analysis/stimulated_volume.hpp"
#include "coupler/seismicity/moment_tensor.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

SeismicEvent event_at(const Point& place) {
  SeismicEvent event;
  event.centroid = place;
  return event;
}

SeismicEvent event_of(double time, double moment) {
  SeismicEvent event;
  event.centroid_time = time;
  event.scalar_moment = event.scalar_sum = moment;
  event.magnitude = moment_magnitude(moment);
  return event;
}

std::vector<SeismicEvent> square() {
  return {event_at({-50, -50}), event_at({50, 50}), event_at({50, -50}), event_at({-50, 50})};
}

constexpr double shear_modulus = 32e9 / 2.4;

}  // namespace

TEST_CASE("four events on a square of 100 m: hull 1e5 m3, cells 4000 m3", "[coupler][seismicity][analysis]") {
  const StimulatedVolume found = stimulated_volume(square(), Seismicity{}, 10);
  CHECK(found.hull_volume == 1e5);
  CHECK(found.cell_volume == 4000);
  CHECK(found.hull == std::vector<Point>{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}});
  REQUIRE(found.cells.size() == 4);
  CHECK(found.cells[0].middle == Point{-45, -45});
  CHECK(found.cells[0].events == 1);
}

TEST_CASE("a cell counts from the fewest events on", "[coupler][seismicity][analysis]") {
  std::vector<SeismicEvent> events = square();
  events.push_back(event_at({49, 49}));
  events.push_back(event_at({41, 48}));
  Seismicity controls;
  controls.voxel_events = 2;
  const StimulatedVolume found = stimulated_volume(events, controls, 10);
  REQUIRE(found.cells.size() == 1);
  CHECK(found.cells[0].middle == Point{45, 45});
  CHECK(found.cells[0].events == 2);  // that at (50, 50) lies in the next cell
  CHECK(found.cell_volume == 1000);
  CHECK(found.hull_volume == 1e5);
}

TEST_CASE("stimulated volume of no event, one, two, equal ones and ones on a line",
          "[coupler][seismicity][analysis]") {
  const StimulatedVolume none = stimulated_volume({}, Seismicity{}, 10);
  CHECK(none.hull.empty());
  CHECK(none.hull_volume == 0);
  CHECK(none.cell_volume == 0);
  const StimulatedVolume one =
      stimulated_volume(std::vector<SeismicEvent>(7, event_at({3, 4})), Seismicity{}, 10);
  CHECK(one.hull == std::vector<Point>{{3, 4}});
  CHECK(one.hull_volume == 0);
  CHECK(one.cell_volume == 1000);
  const StimulatedVolume line = stimulated_volume(
      {event_at({0, 0}), event_at({30, 30}), event_at({10, 10}), event_at({20, 20})}, Seismicity{}, 10);
  CHECK(line.hull == std::vector<Point>{{0, 0}, {30, 30}});
  CHECK(line.hull_volume == 0);
  CHECK(line.cell_volume == 4000);
}

TEST_CASE("convex hull: inner points, points on edges and repeated points are no corners",
          "[coupler][seismicity][analysis]") {
  const std::vector<Point> hull =
      convex_hull({{2, 0}, {0, 0}, {1, 0}, {2, 2}, {1, 1}, {0, 2}, {2, 1}, {0, 0}, {1, 3}});
  CHECK(hull == std::vector<Point>{{0, 0}, {2, 0}, {2, 2}, {1, 3}, {0, 2}});
  CHECK(polygon_area(hull) == 5);
}

TEST_CASE("McGarr's bounds: 1, 10 and 100 m3 in the paper's shale allow Mw 0.68, 1.35 and 2.02",
          "[coupler][seismicity][analysis]") {
  // Half a unit of the last digit given.
  CHECK(moment_magnitude(greatest_moment_bound(shear_modulus, 1)) == Approx(0.68).margin(5e-3));
  CHECK(moment_magnitude(greatest_moment_bound(shear_modulus, 10)) == Approx(1.35).margin(5e-3));
  CHECK(moment_magnitude(greatest_moment_bound(shear_modulus, 100)) == Approx(2.02).margin(5e-3));
  CHECK(moment_sum_bound(shear_modulus, 10) == Approx(2 * greatest_moment_bound(shear_modulus, 10)));
}

TEST_CASE("moment budget: sums, greatest event and bounds at each time, whatever the order of the catalogue",
          "[coupler][seismicity][analysis]") {
  const std::vector<SeismicEvent> events{event_of(5, 3e6), event_of(2, 1e6), event_of(9, 2e6)};
  const InjectedVolume injected{{4, 6, 8}, {2, 4, 3}};  // some flows back
  const MomentBudget budget = moment_budget(events, injected, shear_modulus, {0, 2, 5, 7, 20});
  CHECK(budget.cumulative == std::vector<double>{0, 1e6, 4e6, 4e6, 6e6});
  CHECK(budget.greatest == std::vector<double>{0, 1e6, 3e6, 3e6, 3e6});
  CHECK(budget.injected == std::vector<double>{0, 1, 3, 4, 4});
  CHECK(budget.greatest_bound[2] == Approx(3 * shear_modulus));
  CHECK(budget.sum_bound[4] == Approx(8 * shear_modulus));
}

TEST_CASE("event rate: a minute each in long runs, twenty parts in short ones, nothing lost",
          "[coupler][seismicity][analysis]") {
  const std::vector<SeismicEvent> events{event_of(1, 1e6), event_of(59, 1e6), event_of(60, 5e6),
                                         event_of(1490, 2e6), event_of(1500, 2e6)};
  const EventRate minutes = event_rate(events, 1490);
  CHECK(minutes.edge[1] == 60);
  CHECK(minutes.edge.size() == 26);
  CHECK(minutes.events.size() == 25);
  CHECK(minutes.events[0] == 2);
  CHECK(minutes.moment[1] == 5e6);
  CHECK(minutes.events[24] == 2);
  const EventRate parts = event_rate({event_of(0, 1e6), event_of(10, 1e6)}, 10);
  CHECK(parts.edge[1] == 0.5);
  CHECK(parts.events.size() == 20);
  CHECK(parts.events.front() == 1);
  CHECK(parts.events.back() == 1);
}

TEST_CASE("analysis as JSON: everything has its key, and what there is none of is null",
          "[coupler][seismicity][analysis]") {
  Case run_case;
  run_case.rock.youngs_modulus = 32e9;
  run_case.rock.poissons_ratio = 0.2;
  run_case.rock.tensile_strength = 1e6;
  run_case.rock.fracture_energy = 50;
  run_case.mesh.tip_size = 1;
  run_case.domain.thickness = 10;
  SeismicSums sums;
  const nlohmann::json nothing = analysis_json({}, run_case, {}, sums);
  CHECK(nothing["distance"].is_null());
  CHECK(totals_json({}, sums)["seismic_fraction"].is_null());
  CHECK(nothing["events"]["greatest_magnitude"].is_null());
  CHECK(nothing["frequency_magnitude"]["b"].is_null());
  CHECK(nothing["moment"]["cumulative"] == 0);
  CHECK_THAT(nothing["caption"].get<std::string>(), Catch::Contains("No source"));

  run_case.injection.perforations = {{"well", {0, 0}, 1e-5}};
  Stage stage;
  stage.rate = 1e-3;
  run_case.injection.stages = {stage};
  std::vector<SeismicEvent> events = square();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const SeismicEvent with_moment = event_of(static_cast<double>(i + 1), 1e6);
    events[i].centroid_time = with_moment.centroid_time;
    events[i].scalar_moment = 1e6;
    events[i].magnitude = i == 0 ? std::nullopt : with_moment.magnitude;
  }
  events[1].type = EventType::shear;
  sums.seismic_sum = 4e6;
  sums.aseismic_sum = 12e6;
  sums.raw = {1, 2, 3, 4};
  const nlohmann::json some = analysis_json(events, run_case, {{10}, {2}}, sums);
  CHECK(some["events"]["count"] == 4);
  CHECK(totals_json(events, sums)["seismic_fraction"] == 0.25);
  CHECK(some["events"]["types"]["shear"] == 1);
  CHECK(some["events"]["types"]["mixed"] == 3);
  CHECK(totals_json(events, sums)["raw"] == nlohmann::json({1, 2, 3, 4}));
  CHECK(some["frequency_magnitude"]["events"] == 3);
  CHECK(some["distance"]["best_law"] != nullptr);
  CHECK_FALSE(some["distance"]["laws"][0].contains("curve"));
  CHECK(some["moment"]["cumulative"] == 4e6);
  CHECK(some["moment"]["greatest_bound"].get<double>() == Approx(2 * shear_modulus));
  CHECK(some["volume"]["cells"] == 4);
  CHECK_THAT(some["caption"].get<std::string>(), Catch::Contains("Seismic fraction 0.25") &&
                                                     Catch::Contains("0.001 m/s and 10000 Pa") &&
                                                     Catch::Contains("1.5 element sizes"));
}
