// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "common/fracture_network/insertion_json.hpp"
#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/refusal.hpp"
#include "coupler/conformance/topologies.hpp"
#include "coupler/faults/forgery.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 2.2";

Insertion plain_slit() {
  return straight_slit(PumpedSlit::nodes, PumpedSlit::spacing, PumpedSlit::nodes / 2);
}

Message first_advance(const Driver& driver) {
  FractureNetwork network;
  network.apply(plain_slit());
  Message message = driver.advance_message(spring_interval({}, network, 0, PumpedSlit::duration, {}));
  message.revision = 0;
  return message;
}

// ---- before the first topology ----------------------------------------------------------------------

std::string insert_before_welcome(const Candidate& candidate) {
  Driver driver(candidate);
  return require_refusal(driver, driver.insert_message(plain_slit()), {22}, "INSERT before WELCOME");
}

std::string advance_before_insert(const Candidate& candidate) {
  Driver driver(candidate);
  driver.welcome(pumped_case());
  return require_refusal(driver, first_advance(driver), {22}, "ADVANCE before the first INSERT");
}

std::string finish_before_insert(const Candidate& candidate) {
  Driver driver(candidate);
  driver.welcome(pumped_case());
  return require_refusal(driver, driver.command(MessageType::finish), {22}, "FINISH before the first INSERT");
}

std::string advance_before_restore(const Candidate& candidate) {
  Driver driver(candidate);
  Message welcome = driver.welcome_message(pumped_case());
  welcome.body["resumes"] = true;
  driver.participant().say(std::move(welcome));
  return require_refusal(driver, first_advance(driver), {22}, "ADVANCE before RESTORE in a run that resumes");
}

// ---- a participant that has a topology --------------------------------------------------------------

/// A message out of place after an interval.
Check out_of_place(const std::string& check, const std::string& why,
                   const std::function<Message(const PumpedSlit&)>& message) {
  return {.name = check,
          .contract = contract,
          .expected = "FAIL 22 to " + why,
          .carry_out = [message, why](const Candidate& candidate) {
            PumpedSlit scene(candidate);
            scene.advance();
            return require_refusal(scene.driver, message(scene), {22}, why);
          }};
}

Message second_welcome(const PumpedSlit& scene) {
  return scene.driver.welcome_message(pumped_case());
}

Message restore_of_a_running(const PumpedSlit& scene) {
  Message state(MessageType::state);
  const std::vector<std::byte> bytes(16);
  state.add_bytes("state", bytes);
  return scene.driver.restore_message(scene.driver.insertions(), scene.driver.interval(), state);
}

Message advance_over(const PumpedSlit& scene, double begin, double end) {
  CouplingInterval interval = scene.next(PumpedSlit::duration);
  interval.begin = begin;
  interval.end = end;
  return scene.driver.advance_message(interval);
}

Message interval_again(const PumpedSlit& scene) {
  return advance_over(scene, 0, scene.time);
}
Message interval_skipped(const PumpedSlit& scene) {
  return advance_over(scene, scene.time + PumpedSlit::duration, scene.time + 2 * PumpedSlit::duration);
}
Message interval_without_length(const PumpedSlit& scene) {
  return advance_over(scene, scene.time, scene.time);
}
Message interval_backwards(const PumpedSlit& scene) {
  return advance_over(scene, scene.time, scene.time - PumpedSlit::duration / 2);
}

Message unknown_carry(const PumpedSlit& scene) {
  Message message = scene.driver.advance_message(scene.next(PumpedSlit::duration));
  message.body["carry"] = "momentum";
  return message;
}

Message without_end(const PumpedSlit& scene) {
  Message message = scene.driver.advance_message(scene.next(PumpedSlit::duration));
  message.body.erase("end");
  return message;
}

Message of_type(const PumpedSlit& scene, MessageType type) {
  return scene.driver.command(type);
}

Message of_revision(Message message, std::uint64_t revision) {
  message.revision = revision;
  return message;
}

std::string advance_of_an_old_revision(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  const Message old = scene.driver.advance_message(scene.next(PumpedSlit::duration));
  scene.driver.insert(tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time));
  return require_refusal(scene.driver, old, {22}, "ADVANCE made for the revision before");
}

// The lengths fit, only the number tells.
std::string advance_of_a_later_revision(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  return require_refusal(scene.driver,
                         of_revision(scene.driver.advance_message(scene.next(PumpedSlit::duration)), 1), {22},
                         "ADVANCE made for a revision to come");
}

Message insertion_of(const PumpedSlit& scene, const std::function<void(Insertion&)>& change) {
  Insertion insertion = tip_growth(scene.driver.network(), PumpedSlit::spacing, scene.time);
  change(insertion);
  return scene.driver.insert_message(insertion);
}

}  // namespace

std::vector<Check> order_checks() {
  return {
      {.name = "order.insert_before_welcome",
       .contract = contract,
       .expected = "FAIL 22 to INSERT before WELCOME",
       .carry_out = insert_before_welcome},
      {.name = "order.advance_before_insert",
       .contract = contract,
       .expected = "FAIL 22 to ADVANCE before the first INSERT",
       .carry_out = advance_before_insert},
      {.name = "order.finish_before_insert",
       .contract = contract,
       .expected = "FAIL 22 to FINISH before the first INSERT",
       .carry_out = finish_before_insert},
      {.name = "order.advance_before_restore",
       .contract = contract,
       .expected = "FAIL 22 to ADVANCE before RESTORE in a run that resumes",
       .capabilities = {"restore"},
       .carry_out = advance_before_restore},
      out_of_place("order.second_welcome", "a second WELCOME", second_welcome),
      out_of_place("order.restore_of_a_running", "RESTORE to a participant that has a topology",
                   restore_of_a_running),
      out_of_place("order.bye_unasked", "BYE before FINISH",
                   [](const PumpedSlit& scene) { return of_type(scene, MessageType::bye); }),
      out_of_place("order.wrong_direction", "PRESSURE, which only it may say",
                   [](const PumpedSlit& scene) { return of_type(scene, MessageType::pressure); }),
      out_of_place("order.interval_again", "an interval that has been solved already", interval_again),
      out_of_place("order.interval_skipped", "an interval that begins after the end of the last",
                   interval_skipped),
      out_of_place("order.interval_without_length", "an interval without length", interval_without_length),
      out_of_place("order.interval_backwards", "an interval that ends before it begins", interval_backwards),
      out_of_place("order.unknown_carry", "an unknown word for `carry`", unknown_carry),
      out_of_place("order.advance_without_end", "ADVANCE without `end`", without_end),
      {.name = "revision.old",
       .contract = contract,
       .expected = "FAIL 22 to ADVANCE made for the revision before",
       .carry_out = advance_of_an_old_revision},
      {.name = "revision.later",
       .contract = contract,
       .expected = "FAIL 22 to ADVANCE made for a revision to come, even where the lengths fit",
       .carry_out = advance_of_a_later_revision},
      out_of_place("revision.report", "REPORT made for another revision",
                   [](const PumpedSlit& scene) { return of_revision(scene.driver.report_message(), 1); }),
      out_of_place("revision.insertion_skipped", "INSERT of a revision that is not the next",
                   [](const PumpedSlit& scene) {
                     return insertion_of(scene, [](Insertion& insertion) { insertion.revision += 1; });
                   }),
      out_of_place("revision.unknown_node", "INSERT of a segment at a node that does not exist",
                   [](const PumpedSlit& scene) {
                     return insertion_of(
                         scene, [](Insertion& insertion) { insertion.new_segments.front().node_a = 424242; });
                   }),
      out_of_place("revision.node_twice", "INSERT of a node whose id exists",
                   [](const PumpedSlit& scene) {
                     return insertion_of(scene, [&scene](Insertion& insertion) {
                       insertion.new_nodes.front().id = scene.driver.network().nodes().front().id;
                     });
                   }),
      out_of_place("revision.negative_length", "INSERT of a node with a negative length",
                   [](const PumpedSlit& scene) {
                     return insertion_of(scene, [](Insertion& insertion) {
                       insertion.new_nodes.front().lumped_length = -0.25;
                     });
                   }),
  };
}

}  // namespace fissura::coupler::conformance
