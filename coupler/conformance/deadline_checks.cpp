// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/refusal.hpp"
#include "coupler/conformance/topologies.hpp"
#include "coupler/launch/process_tree.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 2.3";
constexpr double short_deadline = 1.5;  // of the coupler, told in WELCOME [s]
/// Beyond a deadline, for looking at the clock and for ending.
constexpr Seconds grace{2.5};

double now() {
  return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A process that has been told of a short deadline, and has its first topology.
void begin(Driver& driver) {
  Message welcome = driver.welcome_message(pumped_case());
  welcome.body["coupler_deadline"] = short_deadline;
  driver.participant().say(std::move(welcome));
  driver.insert(straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2));
}

std::string silent_coupler(const Candidate& candidate) {
  Driver driver(candidate);
  begin(driver);
  driver.participant().fall_silent();
  const double start = now();
  const std::string end =
      require_end(driver, Seconds(short_deadline) + grace, {20, 21},
                  fmt::format("the last word of a coupler whose deadline is {:g} s", short_deadline));
  const double waited = now() - start;
  constexpr double early = 0.9;
  require(waited >= early * short_deadline, fmt::format("a wait of {:g} s for the coupler", short_deadline),
          fmt::format("{:.2f} s", waited));
  return fmt::format("{} after {:.2f} s", end, waited);
}

std::string kept_alive(const Candidate& candidate) {
  Driver driver(candidate);
  begin(driver);
  constexpr Seconds between{0.4};
  constexpr int signs = 6;
  for (int k = 0; k < signs; ++k) {
    std::this_thread::sleep_for(between);
    Message sign(MessageType::progress);
    sign.body = {{"phase", "structure"}, {"count", k}};
    driver.participant().say(std::move(sign));
  }
  (void)driver.advance(spring_interval({}, driver.network(), 0, PumpedSlit::duration, {}));
  return fmt::format("an interval was answered after {:g} s of nothing but PROGRESS",
                     signs * between.count());
}

std::string coupler_gone(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  scene.driver.participant().hang_up();
  return require_end(scene.driver, grace, {20, 21}, "the end of the coupler's connection");
}

std::string coupler_fails(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  Message failure(MessageType::fail);
  failure.body = {
      {"role", "coupler"}, {"phase", "structure"}, {"reason", "the structure died"}, {"exit_code", 0}};
  scene.driver.participant().say(std::move(failure));
  return require_end(scene.driver, grace, {20}, "FAIL of the coupler");
}

std::string finishes(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  const nlohmann::json figures = scene.driver.finish();
  const auto found = figures.find("work_seconds");
  require(found != figures.end() && found->is_number(), "work_seconds in `figures` of BYE", figures.dump());
  require_within("work_seconds", found->get<double>(), 0, scene.driver.patience().count());
  return fmt::format("BYE with {} figures, exit code 0", figures.size());
}

/// What is on its way when a process ends may be lost with its connection.
std::string waits_for_bye(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  (void)scene.driver.request(scene.driver.command(MessageType::finish), MessageType::bye);
  constexpr Seconds short_wait{0.3};
  if (const std::optional<ProcessEnd> end = scene.driver.participant().wait_for_end(short_wait))
    throw Deviation("the process to wait for the BYE of the coupler", "its process " + in_words(*end));
  scene.driver.participant().say(Message(MessageType::bye));
  return require_end(scene.driver, Seconds(2), {0}, "the BYE of the coupler");
}

/// The process that said HELLO, if it is one of those that were started here; else the one that was started.
void send_signal(Driver& driver, int signal) {
  const auto pid = static_cast<pid_t>(driver.greeting().pid);
  if (descendants().contains(pid))
    ::kill(pid, signal);
  else
    driver.participant().send_signal(signal);
}

std::string passes_stop_on(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  (void)scene.driver.participant().say(scene.driver.report_message());
  if (!std::holds_alternative<Message>(scene.driver.participant().hear(scene.driver.patience())))
    throw Deviation("FIELDS", "nothing");
  send_signal(scene.driver, SIGTERM);
  const double start = now();
  std::optional<int> told;
  while (!told && now() - start < grace.count()) {
    const Heard heard = scene.driver.participant().hear(Seconds(0.05));
    if (!std::holds_alternative<Silence>(heard))
      scene.driver.deviate("PROGRESS with stop_signal, and nothing else", heard);
    for (const HeardProgress& progress : scene.driver.participant().progress())
      if (progress.stop_signal) told = progress.stop_signal;
  }
  const double waited = now() - start;
  require(told == SIGTERM, "PROGRESS with stop_signal 15 after SIGTERM",
          told ? fmt::format("stop_signal {}", *told) : "no stop_signal");
  scene.advance();
  return fmt::format("stop_signal {} after {:.2f} s, and it serves on", *told, waited);
}

std::string ignores_interrupt(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  send_signal(scene.driver, SIGINT);
  constexpr Seconds long_enough{0.3};
  const Heard heard = scene.driver.participant().hear(long_enough);
  if (!std::holds_alternative<Silence>(heard)) scene.driver.deviate("no change after SIGINT", heard);
  scene.advance();
  return "SIGINT, which Ctrl-C sends to all, changes nothing: the coupler decides";
}

/// Longest time without a word between a command and its answer.
double longest_gap(const std::vector<HeardProgress>& progress, double answered) {
  double before = 0, longest = 0;
  for (const HeardProgress& each : progress) {
    longest = std::max(longest, each.time - before);
    before = each.time;
  }
  return std::max(longest, answered - before);
}

struct Work {
  std::size_t nodes = 0;
  int stages = 0;  ///< of pumping, all within the interval
  std::size_t signs = 0;
  double seconds = 0;  ///< from the command to the answer, wall
  double gap = 0;      ///< longest time without a word in them [s]
};

Work work_on(const Candidate& candidate, std::size_t nodes, int stages) {
  constexpr double length = 4;  // of the slit [m]
  Case run_case = pumped_case();
  for (int stage = 1; stage < stages; ++stage)
    add_stage(run_case, stage * PumpedSlit::duration / stages, PumpedSlit::rate / (1 + stage % 2));
  Candidate patient = candidate;
  patient.patience = Seconds(60);
  PumpedSlit scene(patient, run_case,
                   straight_slit(nodes, length / static_cast<double>(nodes), nodes / 2));
  const double start = now();
  scene.advance(PumpedSlit::duration);
  Work work{.nodes = nodes,
            .stages = stages,
            .signs = scene.driver.participant().progress().size(),
            .seconds = now() - start};
  work.gap = longest_gap(scene.driver.participant().progress(), work.seconds);
  return work;
}

/// A busy machine may hold a process up once, not always.
Work work_with_signs(const Candidate& candidate, std::size_t nodes, int stages) {
  constexpr double longest_silence = 1;
  constexpr int attempts = 3;
  Work work;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    work = work_on(candidate, nodes, stages);
    if (work.gap <= longest_silence) return work;
  }
  throw Deviation(fmt::format("PROGRESS at least every {:g} s while at work on {} nodes through {} stages",
                              longest_silence, nodes, stages),
                  fmt::format("{:.1f} s of silence in {:.1f} s, {} PROGRESS", work.gap, work.seconds, work.signs));
}

/// Ever more nodes, then ever more stages, each of which is a step at least, until an interval takes long.
std::string tells_of_progress(const Candidate& candidate) {
  constexpr double long_work = 1.5;
  constexpr std::size_t most_nodes = 12800;
  constexpr int most_stages = 2048;
  Work work;
  for (std::size_t nodes = 200; nodes <= most_nodes && work.seconds < long_work; nodes *= 4)
    work = work_with_signs(candidate, nodes, 1);
  for (int stages = 8; stages <= most_stages && work.seconds < long_work; stages *= 4)
    work = work_with_signs(candidate, most_nodes, stages);
  return fmt::format("{:.1f} s of work on {} nodes through {} stages: {} PROGRESS, never {:.2f} s without",
                     work.seconds, work.nodes, work.stages, work.signs, work.gap);
}

}  // namespace

std::vector<Check> deadline_checks() {
  return {
      {.name = "deadline.silent_coupler",
       .contract = contract,
       .expected = "a coupler that says nothing for coupler_deadline is given up: the process ends by itself",
       .carry_out = silent_coupler},
      {.name = "deadline.kept_alive",
       .contract = contract,
       .expected = "PROGRESS of the coupler is a word, too: the process stays",
       .carry_out = kept_alive},
      {.name = "deadline.coupler_gone",
       .contract = contract,
       .expected = "the process ends by itself when the connection of the coupler ends",
       .carry_out = coupler_gone},
      {.name = "deadline.coupler_fails",
       .contract = contract,
       .expected = "the process ends after FAIL of the coupler",
       .carry_out = coupler_fails},
      {.name = "deadline.progress",
       .contract = contract,
       .expected = "a solver at work is never silent for a second",
       .carry_out = tells_of_progress},
      {.name = "signal.stop",
       .contract = contract,
       .expected = "SIGTERM is passed on as PROGRESS with stop_signal, and the process goes on serving",
       .carry_out = passes_stop_on},
      {.name = "signal.interrupt",
       .contract = contract,
       .expected = "SIGINT does not end it",
       .carry_out = ignores_interrupt},
      {.name = "end.finish",
       .contract = "flow_solvers.md 2.2",
       .expected = "FINISH is answered by BYE with figures, and the process ends with 0 once BYE is returned",
       .carry_out = finishes},
      {.name = "end.waits_for_bye",
       .contract = "flow_solvers.md 2.2",
       .expected = "after BYE the process ends with 0 once the coupler has returned it, not before",
       .carry_out = waits_for_bye},
  };
}

}  // namespace fissura::coupler::conformance
