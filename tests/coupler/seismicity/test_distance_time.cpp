// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "coupler/seismicity/analysis/distance_time.hpp"

using namespace fissura;
using namespace fissura::coupler;

namespace {

constexpr double begin_of_pumping = 10;

Case pumped(std::vector<Stage> later) {
  Case value;
  value.injection.perforations = {{"west", {-100, 3}, 1e-5}, {"east", {100, 3}, 1e-5}};
  Stage waiting;
  waiting.control = StageControl::shut_in;
  Stage pumping;
  pumping.begin = begin_of_pumping;
  pumping.rate = 1e-3;
  value.injection.stages = {waiting, pumping};
  for (const Stage& stage : later) value.injection.stages.push_back(stage);
  return value;
}

Stage shut_in_at(double time) {
  Stage stage;
  stage.begin = time;
  stage.control = StageControl::shut_in;
  return stage;
}

/// At a distance from one perforation or the other, in some direction away from the other one.
SeismicEvent event_at(double time, double distance, std::size_t number) {
  const double side = number % 2 == 0 ? -1 : 1, angle = 0.3 * static_cast<double>(number % 5);
  SeismicEvent event;
  event.centroid_time = begin_of_pumping + time;
  event.centroid = {side * (100 + distance * std::cos(angle)), 3 + distance * std::sin(angle)};
  return event;
}

template <class Front>
std::vector<SeismicEvent> events_on(const Front& front, std::size_t count) {
  std::vector<SeismicEvent> events;
  for (std::size_t i = 1; i <= count; ++i) {
    const double time = 3.0 * static_cast<double>(i);
    events.push_back(event_at(time, front(time), i));
  }
  return events;
}

}  // namespace

TEST_CASE("triggering front and back front at given times", "[coupler][seismicity][analysis]") {
  // Half a unit of the last digit given.
  CHECK(triggering_front(0.1, 60) == Approx(8.683).margin(5e-4));
  CHECK(triggering_front(0.1, 650) == Approx(28.580).margin(5e-4));
  CHECK(triggering_front(0.1, 1500) == Approx(43.416).margin(5e-4));
  CHECK(triggering_front(0.1, 3600) == Approx(67.260).margin(5e-4));
  CHECK(back_front(0.1, 3700, 3600, 2) == Approx(12.184).margin(5e-4));
  CHECK(back_front(0.1, 5400, 3600, 2) == Approx(34.446).margin(5e-4));
  CHECK(back_front(0.1, 7200, 3600, 2) == Approx(44.680).margin(5e-4));
  CHECK(back_front(0.1, 3600, 3600, 2) == 0);
  CHECK(back_front(0.1, 7200, 3600, 3) == Approx(std::sqrt(1.5) * 44.680).epsilon(2e-5));
  CHECK(diffusivity_of(triggering_front(0.1, 1)) == Approx(0.1).epsilon(1e-14));
}

TEST_CASE("events on a triggering front give its diffusivity and the exponent 1/2",
          "[coupler][seismicity][analysis]") {
  const std::size_t count = GENERATE(3u, 10u, 200u, 2000u);
  const auto events = events_on([](double time) { return triggering_front(0.1, time); }, count);
  const DistanceTime found = distance_time(events, pumped({})).value();
  CHECK(found.start == begin_of_pumping);
  CHECK(found.well[0] == Approx(0).margin(1e-14));
  CHECK(found.well[1] == 3);
  REQUIRE(found.fit.has_value());
  CHECK(found.fit->exponent == Approx(0.5).epsilon(1e-9));
  CHECK(found.fit->exponent_sigma.value() < 1e-9);
  REQUIRE(found.nearest.has_value());
  CHECK(found.laws[*found.nearest].name == "diffusion");
  CHECK(found.laws[*found.nearest].diffusivity.value() == Approx(0.1).epsilon(1e-9));
  CHECK(found.laws[*found.nearest].misfit < 1e-9);
  CHECK(found.fits);
  CHECK_THAT(found.verdict, Catch::StartsWith("Diffusive: diffusion fits (t^0.500"));
  CHECK_FALSE(found.back_front.has_value());
  const DistanceCurve& curve = found.laws[0].curve;
  CHECK(curve.time.back() == Approx(begin_of_pumping + 3.0 * static_cast<double>(count)));
  CHECK(curve.distance.back() == Approx(triggering_front(0.1, 3.0 * static_cast<double>(count))));
}

TEST_CASE("events on a fracture that grows as t^(2/3) or t^(4/5) are not diffusive",
          "[coupler][seismicity][analysis]") {
  const auto [exponent, name] = GENERATE(table<double, std::string>({{2.0 / 3, "KGD"}, {4.0 / 5, "PKN"}}));
  const double power = exponent;
  const auto events = events_on([power](double time) { return 2 * std::pow(time, power); }, 300);
  const DistanceTime found = distance_time(events, pumped({})).value();
  CHECK(found.fit.value().exponent == Approx(exponent).epsilon(1e-9));
  CHECK(found.fit->coefficient == Approx(2).epsilon(1e-9));
  CHECK(found.laws[found.nearest.value()].name == name);
  CHECK_FALSE(found.laws[*found.nearest].diffusivity.has_value());
  CHECK(found.fits);
  CHECK_THAT(found.verdict, Catch::StartsWith("Not diffusive: " + name + " fits (t^0."));
}

TEST_CASE("growth between two laws fits neither", "[coupler][seismicity][analysis]") {
  const auto events = events_on([](double time) { return 2 * std::pow(time, 1.0 / 3); }, 300);
  const DistanceTime found = distance_time(events, pumped({})).value();
  CHECK_FALSE(found.fits);
  CHECK_THAT(found.verdict,
             Catch::StartsWith("Not diffusive: no law fits, the nearest is diffusion (t^0.500"));
}

TEST_CASE("the envelope leaves out a twentieth of the events, however far they lie",
          "[coupler][seismicity][analysis]") {
  // In every group of twenty there is one far outlier, eighteen events behind the front and one on it.
  std::vector<SeismicEvent> events;
  for (std::size_t i = 0; i < 400; ++i) {
    const double time = 20 + static_cast<double>(i), front = triggering_front(0.1, time);
    events.push_back(event_at(time, i % 20 == 7 ? 50 * front : i % 20 == 13 ? front : 0.5 * front, i));
  }
  const DistanceTime found = distance_time(events, pumped({})).value();
  CHECK(found.envelope.time.size() == 20);
  CHECK(found.fit.value().exponent == Approx(0.5).epsilon(1e-9));
  CHECK(found.laws[0].diffusivity.value() == Approx(0.1).epsilon(1e-9));
}

TEST_CASE("the standard error of the exponent is that of draws with known scatter",
          "[coupler][seismicity][analysis]") {
  const std::size_t draws = 400;
  double sum = 0, square = 0, mean_sigma = 0;
  std::mt19937_64 generator(5);
  std::normal_distribution<double> scatter(0, 0.1);
  std::vector<double> times;
  for (int i = 1; i <= 30; ++i) times.push_back(i);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    std::vector<double> distances;
    for (const double time : times)
      distances.push_back(3 * std::pow(time, 0.6) * std::exp(scatter(generator)));
    const PowerLaw law = fitted_power_law(times, distances).value();
    sum += law.exponent;
    square += law.exponent * law.exponent;
    mean_sigma += law.exponent_sigma.value() / draws;
  }
  const double mean = sum / draws, deviation = std::sqrt(square / draws - mean * mean);
  CHECK(std::abs(mean - 0.6) < 3 * deviation / std::sqrt(draws));
  CHECK(std::abs(mean_sigma / deviation - 1) < 3 / std::sqrt(2.0 * draws));
}

TEST_CASE("only what happens while pumping is fitted, and a back front follows the shut-in",
          "[coupler][seismicity][analysis]") {
  auto events = events_on([](double time) { return triggering_front(0.1, time); }, 100);
  for (std::size_t i = 1; i <= 50; ++i) events.push_back(event_at(300 + static_cast<double>(i), 500, i));
  events.push_back(event_at(-5, 7, 1));
  const DistanceTime found = distance_time(events, pumped({shut_in_at(begin_of_pumping + 300)})).value();
  CHECK(found.shut_in.value() == begin_of_pumping + 300);
  CHECK(found.distance.size() == events.size());
  CHECK(found.distance[120] == Approx(500));
  CHECK(found.laws[0].diffusivity.value() == Approx(0.1).epsilon(1e-9));
  REQUIRE(found.back_front.has_value());
  CHECK(found.back_front->time.front() == begin_of_pumping + 300);
  CHECK(found.back_front->distance.front() == 0);
  CHECK(found.back_front->distance.back() == Approx(back_front(0.1, 350, 300, 2)).epsilon(1e-8));
}

TEST_CASE("distance over time of hardly any events, or all at one place or time, is told but not fitted",
          "[coupler][seismicity][analysis]") {
  const Case run_case = pumped({});
  const DistanceTime none = distance_time({}, run_case).value();
  CHECK(none.laws.empty());
  CHECK(none.verdict == "No law is fitted: the envelope has 0 point(s), 3 at different times are needed.");
  const DistanceTime two = distance_time({event_at(5, 1, 1), event_at(8, 2, 2)}, run_case).value();
  CHECK(two.laws.size() == 3);
  CHECK_FALSE(two.fit.has_value());
  CHECK_FALSE(two.nearest.has_value());
  const DistanceTime at_once =
      distance_time(std::vector<SeismicEvent>(30, event_at(5, 1, 1)), run_case).value();
  CHECK_FALSE(at_once.fit.has_value());
  CHECK_THAT(at_once.verdict, Catch::Contains("No law is fitted"));
  const auto still = events_on([](double) { return 4.0; }, 40);
  const DistanceTime in_place = distance_time(still, run_case).value();
  CHECK(in_place.fit.value().exponent == Approx(0).margin(1e-12));
  CHECK_FALSE(in_place.fits);
  const auto at_the_well = events_on([](double) { return 0.0; }, 40);
  CHECK(distance_time(at_the_well, run_case).value().envelope.time.size() <= 40);
  CHECK_FALSE(distance_time({event_at(5, 1, 1)}, Case{}).has_value());
}
