// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/conformance/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/case/case_json.hpp"
#include "common/exchange/array_units.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/conformance/expectation.hpp"

namespace fissura::coupler::conformance {

namespace {

constexpr Seconds farewell{3.0};
/// Rounding of a fraction that was computed as a quotient.
constexpr double fraction_slack = 1e-9;
/// A residual is the difference of the entries it comes with, but for rounding of the largest of them.
constexpr double residual_slack = 1e-14;
constexpr double coupler_deadline = 60;

std::string hexadecimal(const RunId& run) {
  std::string text;
  for (const std::uint8_t byte : run) text += fmt::format("{:02x}", byte);
  return text;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of("\n ");
  if (end == std::string::npos) return {};
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

template <typename T>
T entry(const nlohmann::json& object, const char* key) {
  try {
    return exactly<T>(object.at(key));
  } catch (const nlohmann::json::exception&) {
    throw Deviation(fmt::format("an entry \"{}\" in the body", key), object.dump());
  }
}

FluidLedger ledger_of(const nlohmann::json& object) {
  FluidLedger ledger;
  ledger.injected = entry<double>(object, "injected");
  ledger.in_place = entry<double>(object, "in_place");
  if (object.contains("found")) ledger.found = entry<double>(object, "found");
  ledger.in_fractures = entry<double>(object, "in_fractures");
  ledger.leaked = entry<double>(object, "leaked");
  ledger.reset = entry<double>(object, "reset");
  const double largest = std::max({std::abs(ledger.injected), ledger.in_place, ledger.found,
                                   ledger.in_fractures, ledger.leaked, std::abs(ledger.reset)});
  require_close("ledger.residual (injected + in_place + found + reset - in_fractures - leaked)",
                entry<double>(object, "residual"), ledger.residual(), residual_slack * largest);
  return ledger;
}

DrivenOptions options_of(const Candidate& candidate) {
  return {.command = candidate.command,
          .run = conformance_run_id(),
          .epoch = candidate.epoch,
          .printed = Printed::kept};
}

}  // namespace

RunId conformance_run_id() {
  RunId run;
  for (std::size_t i = 0; i < run.size(); ++i) run[i] = static_cast<std::uint8_t>(0xc0 + i);
  return run;
}

std::optional<std::vector<double>> ReportedFields::find(const std::string& name) const {
  for (const FlowField& field : fields)
    if (field.name == name) return field.values;
  return std::nullopt;
}

// ---- the beginning ----------------------------------------------------------------------------------

Driver::Driver(const Candidate& candidate) : candidate_(candidate), participant_(options_of(candidate)) {
  hear_hello();
}

Driver::Driver(const Candidate& candidate, const Case& run_case, const Insertion& first) : Driver(candidate) {
  welcome(run_case);
  insert(first);
}

void Driver::hear_hello() {
  const Heard heard = participant_.hear(candidate_.patience);
  const auto* hello = std::get_if<Message>(&heard);
  if (hello == nullptr || hello->type != MessageType::hello) deviate("HELLO as the first message", heard);
  greeting_.role = entry<std::string>(hello->body, "role");
  greeting_.solver = entry<std::string>(hello->body, "solver");
  greeting_.version = entry<std::string>(hello->body, "version");
  greeting_.pid = entry<long>(hello->body, "pid");
  if (hello->body.contains("capabilities"))
    greeting_.capabilities = entry<std::set<std::string>>(hello->body, "capabilities");
  if (hello->body.contains("physics"))
    greeting_.physics = entry<std::set<std::string>>(hello->body, "physics");
}

void Driver::welcome(const Case& run_case) {
  participant_.say(welcome_message(run_case));
}

void Driver::resume(const Case& run_case, const std::vector<Insertion>& insertions, std::uint64_t interval,
                    const std::vector<std::byte>& state) {
  Message message(MessageType::state);
  message.add_bytes("state", state);
  resume(run_case, insertions, interval, message);
}

void Driver::resume(const Case& run_case, const std::vector<Insertion>& insertions, std::uint64_t interval,
                    const Message& state) {
  Message resuming = welcome_message(run_case);
  resuming.body["resumes"] = true;
  participant_.say(std::move(resuming));
  const Message restore = restore_message(insertions, interval, state);
  for (const Insertion& insertion : insertions) network_.apply(insertion);
  insertions_ = insertions;
  interval_ = interval;
  require_hash(request(restore, MessageType::restored));
}

// ---- the conversation -------------------------------------------------------------------------------

void Driver::insert(const Insertion& insertion) {
  const Message command = insert_message(insertion);
  network_.apply(insertion);
  insertions_.push_back(insertion);
  require_hash(request(command, MessageType::acknowledge));
}

FlowAnswer Driver::advance(const CouplingInterval& interval) {
  const Message command = advance_message(interval);
  interval_ = command.interval;
  time_ = interval.end;
  return answer_of(request(command, MessageType::pressure));
}

ReportedFields Driver::report() {
  const Message fields = request(report_message(), MessageType::fields);
  ReportedFields reported;
  reported.geometry = entry<std::uint64_t>(fields.body, "geometry");
  for (const Array& array : fields.arrays) {
    if (array.dtype != "float64") continue;
    reported.fields.push_back({.name = array.name,
                               .unit = array.unit,
                               .values = fields.numbers(array.name),
                               .columns = array.shape.size() > 1 ? std::optional<std::size_t>(array.shape[1]) : std::nullopt});
  }
  return reported;
}

Message Driver::save() {
  return request(command(MessageType::save), MessageType::state);
}

nlohmann::json Driver::finish() {
  const Message bye = request(command(MessageType::finish), MessageType::bye);
  participant_.say(Message(MessageType::bye));
  const std::optional<ProcessEnd> end = participant_.wait_for_end(farewell);
  if (!end)
    throw Deviation("the end of the process after BYE",
                    fmt::format("it is alive after {} s", farewell.count()));
  if (end->signal || end->exit_code != 0) throw Deviation("exit code 0 after BYE", in_words(*end));
  return entry<nlohmann::json>(bye.body, "figures");
}

// ---- commands ---------------------------------------------------------------------------------------

Message Driver::command(MessageType type) const {
  Message message(type);
  message.interval = interval_;
  message.revision = network_.empty() ? 0 : network_.revision();
  return message;
}

Message Driver::welcome_message(const Case& run_case) const {
  Message message(MessageType::welcome);
  message.body = {{"run_id", hexadecimal(conformance_run_id())},
                  {"case", case_to_json(run_case)},
                  {"threads", 1},
                  {"coupler_deadline", coupler_deadline},
                  {"resumes", false}};
  return message;
}

Message Driver::insert_message(const Insertion& insertion) const {
  Message message = command(MessageType::insert);
  message.revision = insertion.revision;
  message.body["insertion"] = insertion_to_json(insertion);
  return message;
}

Message Driver::advance_message(const CouplingInterval& interval) const {
  Message message = command(MessageType::advance);
  message.interval = interval_ + 1;
  message.body = {{"begin", interval.begin},
                  {"end", interval.end},
                  {"carry", interval.carry == Carry::content ? "content" : "pressure"}};
  message.add("aperture", "m", interval.aperture);
  message.add("aperture_rate", "m/s", interval.aperture_rate);
  message.add("reference_pressure", "Pa", interval.reference_pressure);
  message.add("compliance", "m/Pa", interval.compliance);
  message.add("closed", "1", std::vector<double>(interval.closed.begin(), interval.closed.end()));
  if (!interval.arm_aperture_a.empty()) message.add("arm_aperture_a", "m", interval.arm_aperture_a);
  if (!interval.arm_aperture_b.empty()) message.add("arm_aperture_b", "m", interval.arm_aperture_b);
  return message;
}

Message Driver::report_message() const {
  Message message = command(MessageType::report);
  message.body["time"] = time_;
  return message;
}

Message Driver::restore_message(const std::vector<Insertion>& insertions, std::uint64_t interval,
                                const Message& state) const {
  Message message(MessageType::restore);
  message.interval = interval;
  message.revision = insertions.back().revision;
  message.body = state.body;
  message.body.erase("arrays");
  message.arrays = state.arrays;
  message.body["insertions"] = nlohmann::json::array();
  for (const Insertion& insertion : insertions)
    message.body["insertions"].push_back(insertion_to_json(insertion));
  return message;
}

// ---- answers ----------------------------------------------------------------------------------------

Message Driver::request(const Message& command, MessageType expected) {
  Heard heard = participant_.ask(command, candidate_.patience);
  auto* answer = std::get_if<Message>(&heard);
  if (answer == nullptr || answer->type != expected)
    deviate(fmt::format("{} as the answer to {} of interval {}", name(expected), name(command.type),
                        command.interval),
            heard);
  const std::string what = fmt::format("{} of interval {}", name(expected), command.interval);
  require(answer->interval == command.interval, what,
          fmt::format("{} of interval {}", name(expected), answer->interval));
  if (expected != MessageType::bye && expected != MessageType::state)
    require(answer->revision == command.revision,
            fmt::format("{} made for revision {}", what, command.revision),
            fmt::format("revision {}", answer->revision));
  if (const std::optional<std::string> fault = wrong_unit(*answer))
    throw Deviation("SI units of the protocol", *fault);
  return std::move(*answer);
}

FlowAnswer Driver::answer_of(const Message& pressure) const {
  const std::size_t count = network_.nodes().size();
  FlowAnswer answer;
  try {
    answer.pressure = pressure.numbers("pressure", count);
    answer.aperture_predicted = pressure.numbers("aperture_predicted", count);
    answer.filled = pressure.numbers("filled", count);
  } catch (const Error& fault) {
    throw Deviation(fmt::format("pressure, aperture_predicted and filled of {} nodes, all finite", count),
                    fault.what());
  }
  constexpr double any = 1e300;
  require_all_within("pressure of node", answer.pressure, 0, any);
  require_all_within("aperture_predicted of node", answer.aperture_predicted, 0, any);
  require_all_within("filled of node", answer.filled, 0, 1 + fraction_slack);
  for (std::size_t i = 0; i < count; ++i)
    if (answer.pressure[i] > 0)
      require_close(fmt::format("filled of node {}, which has a pressure", i), answer.filled[i], 1,
                    fraction_slack);
  answer.ledger = ledger_of(entry<nlohmann::json>(pressure.body, "ledger"));
  answer.well_pressure = entry<double>(pressure.body, "well_pressure");
  answer.rate = entry<double>(pressure.body, "rate");
  const auto newton = entry<nlohmann::json>(pressure.body, "newton");
  answer.converged = entry<bool>(newton, "converged");
  answer.iterations = entry<int>(newton, "iterations");
  answer.halvings = entry<int>(newton, "halvings");
  answer.residual = entry<double>(newton, "residual");
  require(answer.converged, "newton.converged true", "false");
  return answer;
}

void Driver::require_hash(const Message& answer) const {
  require_same(fmt::format("topology hash after revision {}", network_.revision()),
               entry<std::string>(answer.body, "hash"), network_.topology_hash());
}

void Driver::deviate(const std::string& expected, const Heard& heard) const {
  const std::string printed = last_line(participant_.printed());
  throw Deviation(expected, in_words(heard) + (printed.empty() ? "" : "; it printed: " + printed));
}

std::vector<double> content_of(const FlowAnswer& answer, double bulk_modulus) {
  std::vector<double> content(answer.pressure.size());
  for (std::size_t i = 0; i < content.size(); ++i)
    content[i] = std::min(answer.filled[i], 1.0) * answer.aperture_predicted[i] *
                 (1 + answer.pressure[i] / bulk_modulus);
  return content;
}

}  // namespace fissura::coupler::conformance
