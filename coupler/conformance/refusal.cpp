// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/refusal.hpp"

#include <fmt/format.h>

#include "common/errors.hpp"
#include "coupler/conformance/expectation.hpp"

namespace fissura::coupler::conformance {

namespace {

/// From FAIL to the end of the process, once the coupler has answered.
constexpr Seconds farewell{3.0};

std::string listed(const std::set<int>& codes) {
  std::string text;
  for (const int code : codes) text += fmt::format("{}{}", text.empty() ? "" : " or ", code);
  return text;
}

std::string word(const Message& fail, const char* key) {
  const auto found = fail.body.find(key);
  return found != fail.body.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

std::string require_refusal(Driver& driver, const Message& message, const std::set<int>& codes,
                            const std::string& why) {
  return require_refusal(driver, driver.participant().stamped(message), codes, why);
}

std::string require_refusal(Driver& driver, const Frames& frames, const std::set<int>& codes,
                            const std::string& why) {
  const std::string expected = fmt::format("FAIL {} to {}", listed(codes), why);
  driver.participant().say_frames(frames);
  const Heard heard = driver.participant().hear(driver.patience());
  const auto* failure = std::get_if<ToldFailure>(&heard);
  if (failure == nullptr || !codes.contains(failure->exit_code())) driver.deviate(expected, heard);
  require_same("role of FAIL", word(failure->message, "role"), "network");
  require(!word(failure->message, "reason").empty(), "a sentence as the reason of FAIL",
          failure->message.body.dump());
  require(failure->message.body.contains("phase"), "a phase in FAIL", failure->message.body.dump());

  Message end(MessageType::fail);
  end.body = {{"role", "coupler"}, {"phase", "conformance"}, {"reason", "the run ends"}, {"exit_code", 0}};
  driver.participant().say(end);
  const Heard then = driver.participant().hear(farewell);
  if (std::holds_alternative<Message>(then) || std::holds_alternative<ToldFailure>(then) ||
      std::holds_alternative<Nonsense>(then))
    driver.deviate("no word after FAIL", then);
  (void)require_end(driver, farewell, {failure->exit_code()}, "FAIL");
  return in_words(heard);
}

std::string require_end(Driver& driver, Seconds patience, const std::set<int>& codes,
                        const std::string& why) {
  const std::optional<ProcessEnd> end = driver.participant().wait_for_end(patience);
  const std::string expected = fmt::format("the end of its process with exit code {} within {:g} s after {}",
                                           listed(codes), patience.count(), why);
  if (!end) throw Deviation(expected, "it is still alive");
  if (end->signal || !codes.contains(end->exit_code))
    throw Deviation(expected, "its process " + in_words(*end));
  return "its process " + in_words(*end);
}

}  // namespace fissura::coupler::conformance
