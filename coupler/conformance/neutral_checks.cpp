// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/refusal.hpp"
#include "coupler/conformance/topologies.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 6.2";
/// Sums are formed in another order by everybody.
constexpr double rounding = 1e-9;
/// A solver that begins an iteration elsewhere ends as near to the solution as it solves its equations.
constexpr double solution_tolerance = 1e-6;
const std::set<std::string> needed{"save", "restore", "neutral_state"};

struct NeutralArray {
  const char* name;
  const char* unit;
};
constexpr NeutralArray node_arrays[] = {
    {"neutral_content", "m"},       {"neutral_pressure", "Pa"},         {"neutral_leaked", "m"},
    {"neutral_exposure_time", "s"}, {"neutral_contact_pressure", "Pa"}, {"neutral_fluid_fraction", "1"},
    {"neutral_joining", "1"}};

/// STATE without what only its own solver understands.
Message neutral_part(const Message& state) {
  Message neutral(MessageType::state);
  if (!state.body.contains("neutral")) throw Deviation("`neutral` in the body of STATE", state.body.dump());
  neutral.body["neutral"] = state.body["neutral"];
  for (const NeutralArray& array : node_arrays) {
    const auto found = std::find_if(state.arrays.begin(), state.arrays.end(),
                                    [&array](const Array& each) { return each.name == array.name; });
    if (found == state.arrays.end())
      throw Deviation(fmt::format("the array {} in STATE", array.name), "none");
    require_same(fmt::format("unit of {}", array.name), found->unit, array.unit);
    neutral.arrays.push_back(*found);
  }
  return neutral;
}

double ledger_entry(const Message& state, const char* key) {
  const nlohmann::json ledger = state.body["neutral"].value("ledger", nlohmann::json::object());
  if (!ledger.contains(key) || !ledger[key].is_number())
    throw Deviation(fmt::format("neutral.ledger.{}", key), ledger.dump());
  return ledger[key].get<double>();
}

std::string told(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(4);
  const Message state = neutral_part(scene.driver.save());
  const nlohmann::json& body = state.body["neutral"];
  for (const char* key : {"time", "well_pressure", "rate", "entry_rate", "entry_pressure"})
    require(body.contains(key) && body[key].is_number(), fmt::format("the number neutral.{}", key),
            body.dump());
  require(body.contains("started") && body["started"].is_boolean(), "neutral.started true or false",
          body.dump());
  require_close("neutral.time [s]", body["time"].get<double>(), scene.time, 0);
  require(body["started"].get<bool>(), "neutral.started true after an interval", "false");
  for (const NeutralArray& array : node_arrays)  // one fluid: one column
    (void)state.numbers(array.name, PumpedSlit::nodes);
  const std::vector<double> content = state.numbers("neutral_content");
  require_ratio("content of all nodes [m3]", water::thickness * integral(scene.driver.network(), content),
                scene.last.ledger.in_fractures, rounding);
  require_ratio("neutral.ledger.in_fractures [m3]", ledger_entry(state, "in_fractures"),
                scene.last.ledger.in_fractures, rounding);
  require_ratio("neutral.ledger.injected [m3]", ledger_entry(state, "injected"), scene.last.ledger.injected,
                rounding);
  require_same_bits("neutral_pressure of node", state.numbers("neutral_pressure"), scene.last.pressure);
  require_all_close("neutral_fluid_fraction of node", state.numbers("neutral_fluid_fraction"),
                    std::vector<double>(PumpedSlit::nodes, 1.0), rounding);
  return fmt::format("content {:.9g} m3, ledger {:.9g} m3",
                     water::thickness * integral(scene.driver.network(), content),
                     scene.last.ledger.in_fractures);
}

/// A scene with an insertion in it.
void begin(PumpedSlit& scene) {
  scene.advance_many(3);
  scene.driver.insert(junction(scene.driver.network(), 2, 2, PumpedSlit::spacing, scene.time));
  scene.advance_many(3);
}

std::string taken_up(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  begin(scene);
  const Message given = neutral_part(scene.driver.save());
  Driver driver(candidate);
  driver.resume(pumped_case(), scene.driver.insertions(), scene.driver.interval(), given);
  const Message taken = neutral_part(driver.save());
  for (const char* name :
       {"neutral_content", "neutral_leaked", "neutral_exposure_time", "neutral_contact_pressure"})
    require_same_bits(fmt::format("{} of node", name), taken.numbers(name), given.numbers(name));
  for (const char* key : {"injected", "in_place", "found", "in_fractures", "leaked", "reset"}) {
    const double before = ledger_entry(given, key);
    require_close(fmt::format("neutral.ledger.{} [m3]", key), ledger_entry(taken, key), before,
                  1e-14 * std::abs(before));
  }
  require_close("neutral.time [s]", taken.body["neutral"].value("time", -1.0), scene.time, 0);
  return "content, leaked volume and exposure are the same bits, the ledger is the same";
}

/// `scene` goes on, another process takes its neutral state up and goes on alike.
std::string goes_on(const Candidate& candidate, const Case& run_case, PumpedSlit& scene) {
  const Message given = neutral_part(scene.driver.save());
  Driver driver(candidate);
  driver.resume(run_case, scene.driver.insertions(), scene.driver.interval(), given);
  double greatest = 0;
  for (int k = 0; k < 4; ++k) {
    if (k == 2) {
      const Insertion growth = tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time);
      scene.driver.insert(growth);
      driver.insert(growth);
    }
    const FlowAnswer other = driver.advance(scene.next(PumpedSlit::duration));
    scene.advance();
    const double scale = *std::max_element(scene.last.pressure.begin(), scene.last.pressure.end());
    for (std::size_t i = 0; i < other.pressure.size(); ++i) {
      require_close(fmt::format("pressure of node {} in interval {} after it [Pa]", i, k + 1),
                    other.pressure[i], scene.last.pressure[i], solution_tolerance * scale);
      greatest = std::max(greatest, std::abs(other.pressure[i] - scene.last.pressure[i]) / scale);
    }
    require_ratio("ledger.injected [m3]", other.ledger.injected, scene.last.ledger.injected, 1e-12);
    require_ratio("ledger.in_fractures [m3]", other.ledger.in_fractures, scene.last.ledger.in_fractures,
                  solution_tolerance);
    require_close("ledger.leaked [m3]", other.ledger.leaked, scene.last.ledger.leaked,
                  solution_tolerance * scene.last.ledger.injected);
    require_close("ledger.residual [m3]", other.ledger.residual(), 0, 1e-10 * other.ledger.in_fractures);
  }
  return fmt::format("pressures differ by {:.1e} of the greatest", greatest);
}

std::string goes_on_plain(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  begin(scene);
  return goes_on(candidate, pumped_case(), scene);
}

// Without insertions before it: how a cell was swept by the tip is not part of the neutral state.
std::string goes_on_leaking(const Candidate& candidate) {
  Case run_case = pumped_case();
  run_case.leak_off = {.coefficient = 1e-6, .spurt_volume = 1e-6};
  PumpedSlit scene(candidate, run_case,
                   straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2));
  scene.advance_many(4);
  return goes_on(candidate, run_case, scene);
}

std::string goes_on_in_a_ramp(const Candidate& candidate) {
  Case run_case = pumped_case();
  Stage ramp = run_case.injection.stages.front();
  ramp.begin = 0.4;
  ramp.ramp = 1;
  ramp.rate *= 3;
  run_case.injection.stages.push_back(ramp);
  PumpedSlit scene(candidate, run_case,
                   straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2));
  begin(scene);
  return goes_on(candidate, run_case, scene);
}

std::string from_the_beginning(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  const Message given = neutral_part(scene.driver.save());
  require(!given.body["neutral"].value("started", true), "neutral.started false before the first interval",
          "true");
  Driver driver(candidate);
  driver.resume(pumped_case(), scene.driver.insertions(), scene.driver.interval(), given);
  const FlowAnswer other = driver.advance(scene.next(PumpedSlit::duration));
  scene.advance();
  require_ratio("ledger.in_place [m3]", other.ledger.in_place, scene.last.ledger.in_place, 1e-12);
  require_all_close(
      "pressure of node", other.pressure, scene.last.pressure,
      solution_tolerance * *std::max_element(scene.last.pressure.begin(), scene.last.pressure.end()));
  return fmt::format("in place {:.6g} m3, as without", other.ledger.in_place);
}

std::string refuses(const Candidate& candidate, const std::set<int>& codes, const std::string& why,
                    void (*spoil)(Message&)) {
  PumpedSlit scene(candidate);
  begin(scene);
  Message state = neutral_part(scene.driver.save());
  spoil(state);
  Driver driver(candidate);
  Message welcome = driver.welcome_message(pumped_case());
  welcome.body["resumes"] = true;
  driver.participant().say(std::move(welcome));
  return require_refusal(driver,
                         driver.restore_message(scene.driver.insertions(), scene.driver.interval(), state),
                         codes, "a neutral state with " + why);
}

std::string refuses_negative(const Candidate& candidate) {
  return refuses(candidate, {23, 27}, "a negative leaked volume", [](Message& state) {
    std::vector<double> leaked = state.numbers("neutral_leaked");
    leaked[1] = -1e-6;
    std::erase_if(state.arrays, [](const Array& array) { return array.name == "neutral_leaked"; });
    state.add("neutral_leaked", "m", leaked);
  });
}

std::string refuses_short(const Candidate& candidate) {
  return refuses(candidate, {22, 27}, "one content too few", [](Message& state) {
    std::vector<double> content = state.numbers("neutral_content");
    content.pop_back();
    state.arrays.erase(state.arrays.begin());
    state.add("neutral_content", "m", content);
  });
}

std::string refuses_none(const Candidate& candidate) {
  return refuses(candidate, {22, 27}, "neither `state` nor `neutral`", [](Message& state) {
    state.arrays.clear();
    state.body.erase("neutral");
  });
}

}  // namespace

std::vector<Check> neutral_checks() {
  return {
      {.name = "neutral.told",
       .contract = contract,
       .expected = "STATE carries the neutral state, and its content is that of the ledger",
       .capabilities = needed,
       .carry_out = told},
      {.name = "neutral.taken_up",
       .contract = contract,
       .expected =
           "a fresh process that takes it up has the same content, leaked volume, exposure and ledger",
       .capabilities = needed,
       .carry_out = taken_up},
      {.name = "neutral.goes_on",
       .contract = contract,
       .expected = "it goes on from there as the other would have, through an insertion too",
       .capabilities = needed,
       .carry_out = goes_on_plain},
      {.name = "neutral.goes_on_leaking",
       .contract = contract,
       .expected = "the same with leak-off",
       .physics = {claims::leak_off},
       .capabilities = needed,
       .carry_out = goes_on_leaking},
      {.name = "neutral.goes_on_in_a_ramp",
       .contract = contract,
       .expected = "the same while the rate rises",
       .capabilities = needed,
       .carry_out = goes_on_in_a_ramp},
      {.name = "neutral.from_the_beginning",
       .contract = contract,
       .expected = "a neutral state from before the first interval begins as a run does",
       .capabilities = needed,
       .carry_out = from_the_beginning},
      {.name = "neutral.negative_leaked_volume",
       .contract = contract,
       .expected = "FAIL to a neutral state with a negative leaked volume",
       .capabilities = needed,
       .carry_out = refuses_negative},
      {.name = "neutral.too_few",
       .contract = contract,
       .expected = "FAIL to a neutral state with one content too few",
       .capabilities = needed,
       .carry_out = refuses_short},
      {.name = "neutral.none",
       .contract = contract,
       .expected = "FAIL to RESTORE without any state",
       .capabilities = needed,
       .carry_out = refuses_none},
  };
}

}  // namespace fissura::coupler::conformance
