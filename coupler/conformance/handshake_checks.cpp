// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/flow_cases.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/refusal.hpp"
#include "coupler/conformance/topologies.hpp"
#include "coupler/faults/forgery.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 2.1";
constexpr std::uint64_t other_major = 2, higher_minor = 200;

std::string hello(const Candidate& candidate) {
  Driver driver(candidate);
  const Greeting& greeting = driver.greeting();
  require_same("role", greeting.role, "network");
  require(!greeting.solver.empty() && !greeting.version.empty(), "names of solver and version",
          fmt::format("\"{}\", \"{}\"", greeting.solver, greeting.version));
  require(greeting.pid > 0, "a process id", fmt::format("{}", greeting.pid));
  return fmt::format("{} {}, process {}", greeting.solver, greeting.version, greeting.pid);
}

/// A word that is spelt wrong would claim nothing, and no check of it would be carried out.
std::string claims_known_words(const Candidate& candidate) {
  const std::set<std::string> physics{
      claims::viscous_flow,     claims::leak_off,          claims::power_law,     claims::several_fluids,
      claims::pressure_control, claims::natural_fractures, claims::carry_pressure};
  const std::set<std::string> capabilities{"insert", "report", "save", "restore", "neutral_state", "stack"};
  Driver driver(candidate);
  for (const std::string& word : driver.greeting().capabilities)
    require(capabilities.contains(word), "capabilities of flow_solvers.md 2.1", "\"" + word + "\"");
  if (!driver.greeting().physics) return "it does not tell its physics: all of it is assumed";
  for (const std::string& word : *driver.greeting().physics)
    require(physics.contains(word), "physics of flow_solvers.md 2.1", "\"" + word + "\"");
  return fmt::format("{} words of physics, {} of capabilities", driver.greeting().physics->size(),
                     driver.greeting().capabilities.size());
}

std::string keeps_epoch(const Candidate& candidate) {
  Candidate resumed = candidate;
  resumed.epoch = 3;
  PumpedSlit scene(resumed);
  scene.advance_many(2);
  return fmt::format("all messages after WELCOME of epoch 3 carry {}",
                     scene.driver.participant().last_stamp().epoch);
}

std::string refuses_other_major(const Candidate& candidate) {
  Driver driver(candidate);
  Frames welcome = driver.participant().stamped(driver.welcome_message(pumped_case()));
  restamp(welcome, StampField::major, other_major, 0);
  return require_refusal(driver, welcome, {13, 22}, "WELCOME of major version 2");
}

/// Says a message of a minor version to come: with body keys and an array that nobody knows yet.
void say_of_tomorrow(Driver& driver, Message message) {
  message.body["of_tomorrow"] = {{"depth", 3}, {"words", {"a", "b"}}};
  if (message.type == MessageType::insert) {
    message.body["insertion"]["of_tomorrow"] = true;
    for (nlohmann::json& node : message.body["insertion"]["new_nodes"]) node["of_tomorrow"] = 1.5;
  }
  if (message.type == MessageType::advance) {
    const std::vector<double> values{1, 2, 3};
    message.add("array_of_tomorrow", "kg", values);
  }
  Frames frames = driver.participant().stamped(std::move(message));
  restamp(frames, StampField::minor, higher_minor, 0);
  driver.participant().say_frames(frames);
}

Message hear_of(Driver& driver, MessageType expected) {
  Heard heard = driver.participant().hear(driver.patience());
  auto* message = std::get_if<Message>(&heard);
  if (message == nullptr || message->type != expected) driver.deviate(name(expected), heard);
  return std::move(*message);
}

std::string accepts_higher_minor(const Candidate& candidate) {
  Driver driver(candidate);
  say_of_tomorrow(driver, driver.welcome_message(pumped_case()));
  const Insertion first = straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2);
  say_of_tomorrow(driver, driver.insert_message(first));
  FractureNetwork network;
  network.apply(first);
  const Message acknowledgement = hear_of(driver, MessageType::acknowledge);
  require_same("hash", acknowledgement.value<std::string>("hash"), network.topology_hash());
  const CouplingInterval interval = spring_interval({}, network, 0, PumpedSlit::duration, {});
  Message advance = driver.advance_message(interval);
  advance.revision = 0;
  say_of_tomorrow(driver, std::move(advance));
  const Message pressure = hear_of(driver, MessageType::pressure);
  PumpedSlit plain(candidate);
  plain.advance();
  require_same_bits("pressure of node", pressure.numbers("pressure", PumpedSlit::nodes), plain.last.pressure);
  return fmt::format(
      "WELCOME, INSERT and ADVANCE of minor version {} with unknown keys and array: the same bits",
      higher_minor);
}

std::string refuses_welcome_without_case(const Candidate& candidate) {
  Driver driver(candidate);
  Message welcome = driver.welcome_message(pumped_case());
  welcome.body.erase("case");
  return require_refusal(driver, welcome, {22}, "WELCOME without a case");
}

std::string refuses_impossible_case(const Candidate& candidate) {
  Driver driver(candidate);
  Case impossible = pumped_case();
  impossible.fluids.front().consistency_index = -1;
  return require_refusal(driver, driver.welcome_message(impossible), {10},
                         "a case with a negative viscosity");
}

std::string accepts_rejection(const Candidate& candidate) {
  Driver driver(candidate);
  Message no(MessageType::reject);
  constexpr int role_taken = 12;
  no.body = {{"reason", "the role is held by another process"}, {"exit_code", role_taken}};
  driver.participant().say(std::move(no));
  return require_end(driver, Seconds(3), {role_taken}, "REJECT");
}

std::string dry_case(const Candidate& candidate) {
  Case dry = pumped_case();
  dry.injection = {};
  dry.fluids.clear();
  Insertion slit = straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2);
  slit.new_perforations.clear();
  slit.new_nodes[PumpedSlit::nodes / 2].role = NodeRole::interior;
  PumpedSlit scene(candidate, dry, slit);
  scene.advance_many(2);
  require_all_within("pressure of node", scene.last.pressure, 0, 0);
  require_all_within("filled of node", scene.last.filled, 0, 0);
  require_all_within("aperture_predicted of node", scene.last.aperture_predicted, scene.springs.aperture,
                     scene.springs.aperture);
  const FluidLedger& ledger = scene.last.ledger;
  require_all_within(
      "ledger entry",
      {ledger.injected, ledger.in_place, ledger.found, ledger.in_fractures, ledger.leaked, ledger.reset}, 0,
      0);
  return "no pressure, nothing filled, apertures as given, a ledger of zeros";
}

std::string stamps(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance_many(2);
  const Stamp stamp = scene.driver.participant().last_stamp();
  require(stamp.sequence >= 3, "sequence numbers without gaps from 0", fmt::format("{}", stamp.sequence));
  const auto minor = std::to_integer<int>(scene.driver.participant().last_frames().front().at(5));
  return fmt::format("run, epoch and sequence 0 to {} as they must be, minor version {}", stamp.sequence,
                     minor);
}

}  // namespace

std::vector<Check> handshake_checks() {
  return {
      {.name = "handshake.hello",
       .contract = contract,
       .expected = "HELLO comes first, with role network, solver, version and pid",
       .carry_out = hello},
      {.name = "handshake.stamps",
       .contract = contract,
       .expected =
           "every message carries the run and epoch of WELCOME (HELLO: zeros) and the next sequence number",
       .carry_out = stamps},
      {.name = "handshake.claims",
       .contract = contract,
       .expected = "capabilities and physics are words of the contract",
       .carry_out = claims_known_words},
      {.name = "handshake.epoch",
       .contract = contract,
       .expected = "the epoch is that of WELCOME, whichever it is",
       .carry_out = keeps_epoch},
      {.name = "handshake.other_major_version",
       .contract = contract,
       .expected = "WELCOME of another major version is refused",
       .carry_out = refuses_other_major},
      {.name = "handshake.higher_minor_version",
       .contract = contract,
       .expected = "a higher minor version is accepted, and what is unknown in bodies and arrays is skipped",
       .carry_out = accepts_higher_minor},
      {.name = "handshake.welcome_without_case",
       .contract = contract,
       .expected = "WELCOME without `case` is refused",
       .carry_out = refuses_welcome_without_case},
      {.name = "handshake.impossible_case",
       .contract = contract,
       .expected = "a case with a negative viscosity is refused with FAIL 10 before anything is solved",
       .carry_out = refuses_impossible_case},
      {.name = "handshake.dry_case",
       .contract = contract,
       .expected = "in a case without perforations every pressure is 0 and the ledger is empty",
       .carry_out = dry_case},
      {.name = "handshake.reject",
       .contract = contract,
       .expected = "after REJECT the process ends with the exit code that it names",
       .carry_out = accepts_rejection},
  };
}

}  // namespace fissura::coupler::conformance
