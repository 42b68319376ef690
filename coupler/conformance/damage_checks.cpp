// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <functional>
#include <limits>

#include "coupler/conformance/driver.hpp"
#include "coupler/conformance/expectation.hpp"
#include "coupler/conformance/pumped_slit.hpp"
#include "coupler/conformance/refusal.hpp"
#include "coupler/conformance/topologies.hpp"
#include "coupler/faults/forgery.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr const char* contract = "flow_solvers.md 2.4";

/// An ADVANCE that is spoilt on its way, after two good ones.
Check spoilt(const std::string& check, const std::string& why, const std::set<int>& codes,
             const std::function<void(Frames&)>& spoil) {
  std::string listed;
  for (const int code : codes) listed += fmt::format("{}{}", listed.empty() ? "" : " or ", code);
  return {.name = check,
          .contract = contract,
          .expected = fmt::format("FAIL {} to ADVANCE with {}", listed, why),
          .carry_out = [why, codes, spoil](const Candidate& candidate) {
            PumpedSlit scene(candidate);
            scene.advance_many(2);
            const Message advance = scene.driver.advance_message(scene.next(PumpedSlit::duration));
            Frames frames = scene.driver.participant().stamped(advance);
            spoil(frames);
            return require_refusal(scene.driver, frames, codes, "ADVANCE with " + why);
          }};
}

/// The same before it is stamped, so that everything about it fits but what it says.
Check misspoken(const std::string& check, const std::string& why, const std::set<int>& codes,
                const std::function<void(Message&)>& change) {
  std::string listed;
  for (const int code : codes) listed += fmt::format("{}{}", listed.empty() ? "" : " or ", code);
  return {.name = check,
          .contract = contract,
          .expected = fmt::format("FAIL {} to ADVANCE with {}", listed, why),
          .carry_out = [why, codes, change](const Candidate& candidate) {
            PumpedSlit scene(candidate);
            scene.advance_many(2);
            Message advance = scene.driver.advance_message(scene.next(PumpedSlit::duration));
            change(advance);
            return require_refusal(scene.driver, advance, codes, "ADVANCE with " + why);
          }};
}

Check poisoned(const std::string& check, const std::string& field, double value, const std::string& why) {
  return spoilt(check, why, {23}, [field, value](Frames& frames) { poison(frames, field, 3, value); });
}

std::string lost(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  (void)scene.driver.participant().stamped(scene.driver.report_message());
  return require_refusal(scene.driver, scene.driver.advance_message(scene.next(PumpedSlit::duration)), {22},
                         "a message after one that was lost");
}

std::string doubled(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  const Frames report = scene.driver.participant().stamped(scene.driver.report_message());
  scene.driver.participant().say_frames(report);
  const Heard first = scene.driver.participant().hear(scene.driver.patience());
  if (!std::holds_alternative<Message>(first)) scene.driver.deviate("FIELDS", first);
  return require_refusal(scene.driver, report, {22}, "a message that comes twice");
}

std::string no_word_after_fail(const Candidate& candidate) {
  PumpedSlit scene(candidate);
  scene.advance();
  Message advance = scene.driver.advance_message(scene.next(PumpedSlit::duration));
  advance.arrays.pop_back();
  Heard heard = scene.driver.participant().ask(advance, scene.driver.patience());
  if (!std::holds_alternative<ToldFailure>(heard)) scene.driver.deviate("FAIL", heard);
  scene.driver.participant().say(scene.driver.report_message());
  constexpr Seconds long_enough{3.0};
  heard = scene.driver.participant().hear(long_enough);
  if (!std::holds_alternative<ProcessEnd>(heard) && !std::holds_alternative<ConnectionLost>(heard))
    scene.driver.deviate("the end of its process without another word, though it is asked for REPORT", heard);
  return "REPORT after FAIL was not answered; " +
         require_end(scene.driver, long_enough, {22, 13}, "FAIL to a message without an array");
}

Array& array_named(Message& message, const std::string& name) {
  for (Array& array : message.arrays)
    if (array.name == name) return array;
  throw Deviation("an array " + name, "none");
}

}  // namespace

std::vector<Check> damage_checks() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {
      // ---- what it says -------------------------------------------------------------------------------
      poisoned("values.nan_aperture", "aperture", nan, "an aperture that is not a number"),
      poisoned("values.infinite_aperture", "aperture", infinity, "an infinite aperture"),
      poisoned("values.negative_aperture", "aperture", -1e-5, "a negative aperture"),
      poisoned("values.nan_rate", "aperture_rate", nan, "an aperture rate that is not a number"),
      poisoned("values.nan_reference_pressure", "reference_pressure", nan,
               "a reference pressure that is not a number"),
      poisoned("values.nan_compliance", "compliance", nan, "a compliance that is not a number"),
      poisoned("values.negative_compliance", "compliance", -1e-10, "a negative compliance"),
      misspoken("values.missing_array", "no compliance", {22},
                [](Message& message) {
                  std::erase_if(message.arrays,
                                [](const Array& array) { return array.name == "compliance"; });
                }),
      misspoken("values.wrong_type", "apertures as whole numbers", {22},
                [](Message& message) { array_named(message, "aperture").dtype = "int64"; }),
      spoilt("values.too_few", "one aperture too few", {22},
             [](Frames& frames) { resize(frames, "aperture", PumpedSlit::nodes - 1); }),
      spoilt("values.too_many", "one aperture too many", {22},
             [](Frames& frames) { resize(frames, "aperture", PumpedSlit::nodes + 1); }),
      spoilt("values.other_unit", "apertures in mm", {13},
             [](Frames& frames) { relabel(frames, "aperture", "mm"); }),
      misspoken("values.arms_too_few", "arm apertures for one segment too few", {22},
                [](Message& message) {
                  const std::vector<double> arms(PumpedSlit::nodes - 2, 1e-4);
                  message.add("arm_aperture_a", "m", arms);
                  message.add("arm_aperture_b", "m", arms);
                }),
      misspoken("values.negative_arm", "a negative arm aperture", {23},
                [](Message& message) {
                  std::vector<double> arms(PumpedSlit::nodes - 1, 1e-4);
                  message.add("arm_aperture_a", "m", arms);
                  arms[2] = -1e-4;
                  message.add("arm_aperture_b", "m", arms);
                }),

      misspoken("values.nan_arm", "an arm aperture that is not a number", {23},
                [](Message& message) {
                  std::vector<double> arms(PumpedSlit::nodes - 1, 1e-4);
                  message.add("arm_aperture_a", "m", arms);
                  arms[5] = std::numeric_limits<double>::quiet_NaN();
                  message.add("arm_aperture_b", "m", arms);
                }),
      misspoken("values.one_side_of_arms", "arm apertures of one end only", {22},
                [](Message& message) {
                  const std::vector<double> arms(PumpedSlit::nodes - 1, 1e-4);
                  message.add("arm_aperture_a", "m", arms);
                }),
      misspoken("values.end_no_number", "an end that is no number", {22},
                [](Message& message) { message.body["end"] = nullptr; }),
      misspoken("values.column_too_many", "apertures in two columns", {22},
                [](Message& message) {
                  Array& aperture = array_named(message, "aperture");
                  aperture.shape.push_back(2);
                  aperture.bytes.resize(2 * aperture.bytes.size());
                }),

      // ---- how it arrives -----------------------------------------------------------------------------
      spoilt("message.damaged_array", "a flipped bit in its last array", {22},
             [](Frames& frames) { flip(frames, std::nullopt, 60); }),
      spoilt("message.damaged_body", "a flipped bit in its body", {22},
             [](Frames& frames) { flip(frames, 1, 83); }),
      spoilt("message.damaged_envelope", "a flipped bit in its interval", {22},
             [](Frames& frames) { flip(frames, 0, 8 * 40); }),
      spoilt("message.damaged_magic", "a flipped bit in its first byte", {22},
             [](Frames& frames) { flip(frames, 0, 1); }),
      spoilt("message.truncated_array", "half of its last array", {22},
             [](Frames& frames) { truncate(frames, std::nullopt, std::nullopt); }),
      spoilt("message.truncated_envelope", "an envelope of 63 bytes", {22},
             [](Frames& frames) { truncate(frames, 0, 63); }),
      spoilt("message.frame_missing", "its last frame missing", {22},
             [](Frames& frames) { frames.pop_back(); }),
      spoilt("message.frame_too_many", "one frame too many", {22},
             [](Frames& frames) { frames.emplace_back(8); }),
      spoilt("message.resized_frame", "a last frame longer than its declaration, with a checksum that fits",
             {22}, [](Frames& frames) { oversize(frames, 4096); }),
      spoilt("message.nonsense", "nothing but noise", {22}, [](Frames& frames) { frames = nonsense(200); }),
      spoilt("message.foreign_run", "the run id of another run", {22},
             [](Frames& frames) { restamp(frames, StampField::run, 0x5a, 0); }),
      spoilt("message.wrong_epoch", "another epoch", {22},
             [](Frames& frames) { restamp(frames, StampField::epoch, std::nullopt, 1); }),
      spoilt("message.other_major_version", "another major version", {13, 22},
             [](Frames& frames) { restamp(frames, StampField::major, std::nullopt, 1); }),
      spoilt("message.unknown_type", "a type that there is not", {22},
             [](Frames& frames) { restamp(frames, StampField::type, 199, 0); }),
      spoilt("message.late", "the sequence number of a message before", {22},
             [](Frames& frames) { restamp(frames, StampField::sequence, std::nullopt, -1); }),
      {.name = "message.lost",
       .contract = contract,
       .expected = "FAIL 22 to the message after one that was lost",
       .carry_out = lost},
      {.name = "message.doubled",
       .contract = contract,
       .expected = "FAIL 22 to a message that comes twice",
       .carry_out = doubled},
      {.name = "message.nothing_after_fail",
       .contract = contract,
       .expected = "after FAIL no command is answered any more, and the process ends",
       .carry_out = no_word_after_fail},
  };
}

}  // namespace fissura::coupler::conformance
