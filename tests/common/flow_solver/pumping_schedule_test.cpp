// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/flow_solver/pumping_schedule.hpp"

#include <catch2/catch.hpp>

#include "common/errors.hpp"

using namespace fissura;

TEST_CASE("schedule: a ramp is linear from what the well did before and then stays", "[network][schedule]") {
  const PumpingStage stage{.begin = 2, .control = WellControl::rate, .target = 3e-3, .ramp = 4, .fluid = 0};
  const StageEntry entry{.rate = 1e-3, .pressure = 5e6};
  CHECK(target_at(stage, entry, 2) == Approx(1e-3).epsilon(1e-15));
  CHECK(target_at(stage, entry, 4) == Approx(2e-3).epsilon(1e-15));
  CHECK(target_at(stage, entry, 6) == 3e-3);
  CHECK(target_at(stage, entry, 100) == 3e-3);
}

TEST_CASE("schedule: a pressure ramp starts from the pressure of the well", "[network][schedule]") {
  const PumpingStage stage{
      .begin = 5, .control = WellControl::pressure, .target = 4e6, .ramp = 0.1, .fluid = 0};
  CHECK(target_at(stage, {.rate = 1e-3, .pressure = 6e6}, 5.05) == Approx(5e6).epsilon(1e-12));
}

TEST_CASE("schedule: mean rates over any intervals add up to the exact volume of a ramp",
          "[network][schedule]") {
  const PumpingStage stage{.begin = 1, .control = WellControl::rate, .target = 2e-3, .ramp = 3, .fluid = 0};
  const StageEntry entry{.rate = 5e-4, .pressure = 0};
  const double cuts[] = {1, 1.3, 2.9, 3.7, 4.6, 9};
  double volume = 0;
  for (int k = 0; k < 5; ++k)
    volume += mean_target(stage, entry, cuts[k], cuts[k + 1]) * (cuts[k + 1] - cuts[k]);
  CHECK(volume == Approx(0.5 * (5e-4 + 2e-3) * 3 + 2e-3 * 5).epsilon(1e-15));
}

TEST_CASE("schedule: a stage lasts until the next begins and nothing is pumped before the first",
          "[network][schedule]") {
  const Schedule schedule({{.begin = 1, .control = WellControl::rate, .target = 1, .ramp = 0, .fluid = 0},
                           {.begin = 5, .control = WellControl::rate, .target = 0, .ramp = 0, .fluid = {}}});
  CHECK_FALSE(schedule.stage_from(0.5).has_value());
  CHECK(schedule.stage_from(1) == 0u);
  CHECK(schedule.stage_from(4.999) == 0u);
  CHECK(schedule.stage_from(5) == 1u);
  CHECK(schedule.next_change(0) == 1.0);
  CHECK(schedule.next_change(1) == 5.0);
  CHECK_FALSE(schedule.next_change(5).has_value());
}

TEST_CASE("schedule: stages out of order are refused", "[network][schedule]") {
  CHECK_THROWS_AS(Schedule({{.begin = 5, .control = WellControl::rate, .target = 1, .ramp = 0, .fluid = 0},
                            {.begin = 5, .control = WellControl::rate, .target = 1, .ramp = 0, .fluid = 0}}),
                  fissura::InputError);
}
