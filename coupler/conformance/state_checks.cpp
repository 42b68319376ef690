// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <functional>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/refusal.hpp"
#include "coupler/conformance/topologies.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 6.1";
constexpr int intervals_before = 5, intervals_after = 4;
const std::set<std::string> save_and_restore{"save", "restore"};

void require_same_answer(const std::string& what, const FlowAnswer& obtained, const FlowAnswer& expected) {
  require_same_bits(what + ": pressure of node", obtained.pressure, expected.pressure);
  require_same_bits(what + ": aperture_predicted of node", obtained.aperture_predicted,
                    expected.aperture_predicted);
  require_same_bits(what + ": filled of node", obtained.filled, expected.filled);
  const auto numbers = [](const FlowAnswer& answer) {
    const FluidLedger& ledger = answer.ledger;
    return std::vector{ledger.injected, ledger.in_place, ledger.found,         ledger.in_fractures,
                       ledger.leaked,   ledger.reset,    answer.well_pressure, answer.rate};
  };
  require_same_bits(what + ": ledger, well_pressure and rate, value", numbers(obtained), numbers(expected));
}

Insertion next_growth(const PumpedSlit& scene) {
  return tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time);
}

/// Intervals with an insertion between them.
std::vector<FlowAnswer> go_on(PumpedSlit& scene) {
  std::vector<FlowAnswer> answers;
  for (int k = 0; k < intervals_after; ++k) {
    if (k == intervals_after / 2) scene.driver.insert(next_growth(scene));
    answers.push_back(scene.advance());
  }
  return answers;
}

/// A run with an insertion, up to where it is saved.
void begin(PumpedSlit& scene) {
  scene.advance_many(intervals_before - 2);
  scene.driver.insert(next_growth(scene));
  scene.advance_many(2);
}

/// Answers of another process that goes on from `state` as `scene` does now.
std::vector<FlowAnswer> answers_after_restoring(const Candidate& candidate, const Case& run_case,
                                                const PumpedSlit& scene, const Message& state) {
  Candidate resumed = candidate;
  resumed.epoch = 1;
  Driver driver(resumed);
  driver.resume(run_case, scene.driver.insertions(), scene.driver.interval(), state);
  std::vector<FlowAnswer> answers;
  std::vector<double> pressure = scene.last.pressure;
  double time = scene.time;
  for (int k = 0; k < intervals_after; ++k) {
    if (k == intervals_after / 2) driver.insert(tip_growth(driver.network(), PumpedSlit::spacing, time));
    const CouplingInterval interval =
        spring_interval(scene.springs, driver.network(), time, time + PumpedSlit::duration, pressure);
    answers.push_back(driver.advance(interval));
    pressure = answers.back().pressure;
    time = interval.end;
  }
  return answers;
}

std::string restored(const Candidate& candidate, const Case& run_case) {
  PumpedSlit scene(candidate, run_case,
                   straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2));
  begin(scene);
  const Message state = scene.driver.save();
  const std::vector<FlowAnswer> resumed = answers_after_restoring(candidate, run_case, scene, state);
  const std::vector<FlowAnswer> straight = go_on(scene);
  for (int k = 0; k < intervals_after; ++k)
    require_same_answer(fmt::format("interval {} after RESTORE", k + 1), resumed[k], straight[k]);
  return fmt::format("{} intervals with an insertion between them, the same bits; {} bytes of state",
                     intervals_after, state.bytes("state").size());
}

/// What a state has to hold depends on the physics.
Check restoring(const std::string& name, const std::string& what, const std::set<std::string>& physics,
                const std::function<void(Case&)>& change) {
  return {.name = "state." + name,
          .contract = contract,
          .expected = "the same bits " + what,
          .physics = physics,
          .capabilities = save_and_restore,
          .carry_out = [change](const Candidate& candidate) {
            Case run_case = pumped_case();
            change(run_case);
            return restored(candidate, run_case);
          }};
}

std::string restored_at_the_beginning(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  const Message state = scene.driver.save();
  const std::vector<FlowAnswer> resumed = answers_after_restoring(candidate, pumped_case(), scene, state);
  const std::vector<FlowAnswer> straight = go_on(scene);
  for (int k = 0; k < intervals_after; ++k)
    require_same_answer(fmt::format("interval {} after RESTORE", k + 1), resumed[k], straight[k]);
  return "saved before the first interval: the same bits";
}

std::string saving_changes_nothing(const Candidate& candidate) {
  PumpedSlit plain(candidate), saving(candidate);
  begin(plain);
  begin(saving);
  (void)saving.driver.save();
  (void)saving.driver.save();
  const std::vector<FlowAnswer> expected = go_on(plain), obtained = go_on(saving);
  for (int k = 0; k < intervals_after; ++k)
    require_same_answer(fmt::format("interval {} after SAVE", k + 1), obtained[k], expected[k]);
  return "the same bits with and without SAVE";
}

/// RESTORE of a blob that is not from its own save().
Check refused(const std::string& name, const std::string& what,
              const std::function<void(std::vector<std::byte>&)>& spoil) {
  return {.name = "state." + name,
          .contract = contract,
          .expected = "FAIL 27 to RESTORE with " + what,
          .capabilities = save_and_restore,
          .carry_out = [what, spoil](const Candidate& candidate) {
            PumpedSlit scene(candidate);
            begin(scene);
            std::vector<std::byte> bytes = scene.driver.save().bytes("state");
            require(!bytes.empty(), "a state that is not empty", "no byte");
            spoil(bytes);
            Driver driver(candidate);
            Message welcome = driver.welcome_message(pumped_case());
            welcome.body["resumes"] = true;
            driver.participant().say(std::move(welcome));
            Message spoilt(MessageType::state);
            spoilt.add_bytes("state", bytes);
            return require_refusal(
                driver, driver.restore_message(scene.driver.insertions(), scene.driver.interval(), spoilt),
                {27}, "RESTORE with " + what);
          }};
}

std::string refuses_other_network(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  begin(scene);
  const Message state = scene.driver.save();
  Driver driver(candidate);
  Message welcome = driver.welcome_message(pumped_case());
  welcome.body["resumes"] = true;
  driver.participant().say(std::move(welcome));
  std::vector<Insertion> fewer = scene.driver.insertions();
  fewer.pop_back();
  return require_refusal(driver, driver.restore_message(fewer, scene.driver.interval(), state), {22, 27},
                         "RESTORE of a state with one insertion too few");
}

}  // namespace

std::vector<Check> state_checks() {
  return {
      {.name = "state.bit_identical",
       .contract = contract,
       .expected = "a fresh process goes on from STATE with the same bits, through an insertion too",
       .capabilities = save_and_restore,
       .carry_out = [](const Candidate& candidate) { return restored(candidate, pumped_case()); }},
      restoring("leaking", "with leak-off and spurt", {claims::leak_off},
                [](Case& run_case) { run_case.leak_off = {.coefficient = 1e-6, .spurt_volume = 1e-6}; }),
      restoring("in_a_ramp", "where it was saved while the rate rises", {},
                [](Case& run_case) {
                  Stage ramp = run_case.injection.stages.front();
                  ramp.begin = 0.3;
                  ramp.ramp = 1;
                  ramp.rate *= 3;
                  run_case.injection.stages.push_back(ramp);
                }),
      restoring("power_law", "with a power-law fluid", {claims::power_law},
                [](Case& run_case) {
                  run_case.fluids.front().consistency_index = 0.05;
                  run_case.fluids.front().power_index = 0.6;
                }),
      restoring("displacing", "while one fluid displaces another", {claims::several_fluids},
                [](Case& run_case) {
                  Fluid oil = run_case.fluids.front();
                  oil.name = "oil";
                  oil.consistency_index *= 5;
                  run_case.fluids.push_back(oil);
                  Stage second = run_case.injection.stages.front();
                  second.begin = 0.2;
                  second.fluid = oil.name;
                  run_case.injection.stages.push_back(second);
                }),
      {.name = "state.at_the_beginning",
       .contract = contract,
       .expected = "the same where it was saved before the first interval",
       .capabilities = save_and_restore,
       .carry_out = restored_at_the_beginning},
      {.name = "state.saving_changes_nothing",
       .contract = contract,
       .expected = "answers are the same bits whether SAVE was asked for or not",
       .capabilities = {"save"},
       .carry_out = saving_changes_nothing},
      refused("damaged", "a state of which one bit is flipped",
              [](std::vector<std::byte>& bytes) { bytes[bytes.size() / 2] ^= std::byte{4}; }),
      refused("truncated", "half of a state",
              [](std::vector<std::byte>& bytes) { bytes.resize(bytes.size() / 2); }),
      refused("empty", "an empty state", [](std::vector<std::byte>& bytes) { bytes.clear(); }),
      refused("foreign", "bytes that are no state of its own",
              [](std::vector<std::byte>& bytes) {
                for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(i * 37 % 251);
              }),
      {.name = "state.of_another_network",
       .contract = contract,
       .expected = "FAIL to RESTORE whose insertions do not make the network of the state",
       .capabilities = save_and_restore,
       .carry_out = refuses_other_network},
  };
}

}  // namespace fissura::coupler::conformance
