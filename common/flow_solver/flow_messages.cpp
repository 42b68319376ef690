// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/flow_solver/flow_messages.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "common/errors.hpp"

namespace fissura {

namespace {

constexpr double never = -1;  ///< an exposure time that has not come

nlohmann::json ledger_to_json(const FluidLedger& ledger) {
  return {{"injected", ledger.injected},  {"in_place", ledger.in_place},
          {"found", ledger.found},        {"leaked", ledger.leaked},
          {"reset", ledger.reset},        {"in_fractures", ledger.in_fractures},
          {"residual", ledger.residual()}};
}

double entry(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number())
    throw ProtocolError(fmt::format("neutral state: entry {} is missing or no number", key));
  return found->get<double>();
}

FluidLedger ledger_in(const nlohmann::json& object) {
  return {.injected = entry(object, "injected"),
          .in_place = entry(object, "in_place"),
          .found = entry(object, "found"),
          .in_fractures = entry(object, "in_fractures"),
          .leaked = entry(object, "leaked"),
          .reset = entry(object, "reset")};
}

std::vector<double> not_negative(const Message& message, const char* name, std::size_t count) {
  std::vector<double> values = message.numbers(name, count);
  for (const double value : values)
    if (value < 0) throw ValueError(fmt::format("{} is {}, expected at least 0", name, value));
  return values;
}

}  // namespace

Message pressure_message(const FlowAnswer& answer) {
  Message message(MessageType::pressure);
  message.body["ledger"] = ledger_to_json(answer.ledger);
  message.body["well_pressure"] = answer.well_pressure;
  message.body["rate"] = answer.rate;
  message.body["newton"] = {{"converged", answer.converged},
                            {"iterations", answer.iterations},
                            {"residual", answer.residual},
                            {"halvings", answer.halvings}};
  message.add("pressure", "Pa", answer.pressure);
  message.add("aperture_predicted", "m", answer.aperture_predicted);
  message.add("filled", "1", answer.filled);
  return message;
}

void require_one_per_node(const FlowAnswer& answer, const FractureNetwork& network) {
  const std::size_t nodes = network.nodes().size();
  for (const auto& [name, values] : {std::pair{"pressure", &answer.pressure},
                                     {"aperture_predicted", &answer.aperture_predicted},
                                     {"filled", &answer.filled}})
    if (values->size() != nodes)
      throw Error(ExitCode::internal,
                  fmt::format("the solver gave {} values of {} for {} nodes", values->size(), name, nodes));
}

void add_field(const FlowField& field, Message& fields) {
  if (!field.columns) {
    fields.add(field.name, field.unit, field.values);
    return;
  }
  const std::size_t columns = *field.columns;
  if (columns == 0 || field.values.size() % columns != 0)
    throw Error(ExitCode::internal, fmt::format("the field {} of {} values has no rows of {}", field.name,
                                                field.values.size(), columns));
  fields.add(field.name, field.unit, field.values, field.values.size() / columns, columns);
}

void add_neutral_state(const NeutralFlowState& state, std::size_t fluids, Message& message) {
  message.body["neutral"] = {{"time", state.time},
                             {"started", state.started},
                             {"well_pressure", state.well_pressure},
                             {"rate", state.rate},
                             {"entry_rate", state.entry_rate},
                             {"entry_pressure", state.entry_pressure},
                             {"ledger", ledger_to_json(state.ledger)}};
  std::vector<double> exposure, joining(state.joining.begin(), state.joining.end());
  for (const double time : state.exposure_time) exposure.push_back(std::isfinite(time) ? time : never);
  message.add("neutral_content", "m", state.content);
  message.add("neutral_pressure", "Pa", state.pressure);
  message.add("neutral_leaked", "m", state.leaked);
  message.add("neutral_exposure_time", "s", exposure);
  message.add("neutral_contact_pressure", "Pa", state.contact_pressure);
  message.add("neutral_joining", "1", joining);
  message.add("neutral_fluid_fraction", "1", state.fluid_fraction, state.content.size(), fluids);
}

NeutralFlowState neutral_state_in(const Message& message, std::size_t nodes, std::size_t fluids) {
  const auto body = message.value<nlohmann::json>("neutral");
  NeutralFlowState state;
  state.time = entry(body, "time");
  const auto started = body.find("started"), ledger = body.find("ledger");
  if (started == body.end() || !started->is_boolean() || ledger == body.end())
    throw ProtocolError("neutral state: entry started or ledger is missing");
  state.started = started->get<bool>();
  state.well_pressure = entry(body, "well_pressure");
  state.rate = entry(body, "rate");
  state.entry_rate = entry(body, "entry_rate");
  state.entry_pressure = entry(body, "entry_pressure");
  state.ledger = ledger_in(*ledger);
  state.content = message.numbers("neutral_content", nodes);
  state.pressure = not_negative(message, "neutral_pressure", nodes);
  state.leaked = not_negative(message, "neutral_leaked", nodes);
  for (const double time : message.numbers("neutral_exposure_time", nodes))
    state.exposure_time.push_back(time < 0 ? std::numeric_limits<double>::infinity() : time);
  state.contact_pressure = message.numbers("neutral_contact_pressure", nodes);
  for (const double flag : message.numbers("neutral_joining", nodes))
    state.joining.push_back(flag != 0 ? 1 : 0);
  state.fluid_fraction = message.numbers("neutral_fluid_fraction", nodes * fluids);
  return state;
}

}  // namespace fissura
