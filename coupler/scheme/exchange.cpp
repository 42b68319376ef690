// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/exchange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "common/exchange/value_check.hpp"
#include "common/fracture_network/insertion_json.hpp"

namespace fissura::coupler {

namespace {

struct Range {
  double minimum = 0, maximum = 0;
};

constexpr Range flag{0, 1};
// An aperture of a kilometre is nonsense whatever the case.
constexpr Range possible_aperture{0, 1e3};
// Slack for the rounding of a fraction computed as a quotient.
constexpr double fraction_slack = 1e-9;

std::vector<double> numbers_in(const Message& message, const char* field, const FractureNetwork& network,
                               const Range& range) {
  std::vector<double> values = message.numbers(field, network.nodes().size());
  if (const auto i = first_outside(values, range.minimum, range.maximum)) {
    const NetworkNode& node = network.nodes()[*i];
    throw ValueError(fmt::format("{} of node {} at ({:g}, {:g}) m is {:g}, allowed is [{:g}, {:g}]", field,
                                 node.id, node.x, node.y, values[*i], range.minimum, range.maximum));
  }
  return values;
}

std::vector<double> arm_apertures_in(const Message& message, const char* field,
                                     const FractureNetwork& network) {
  std::vector<double> values = message.numbers(field, network.segments().size());
  if (const auto s = first_outside(values, possible_aperture.minimum, possible_aperture.maximum)) {
    const NetworkSegment& segment = network.segments()[*s];
    throw ValueError(fmt::format("{} of segment {} between nodes {} and {} is {:g}, allowed is [{:g}, {:g}]",
                                 field, segment.id, segment.node_a, segment.node_b, values[*s],
                                 possible_aperture.minimum, possible_aperture.maximum));
  }
  return values;
}

void require_revision(const Message& message, const FractureNetwork& network) {
  if (message.revision != network.revision())
    throw ProtocolError(fmt::format("{} is made for topology revision {}, the network has {}",
                                    name(message.type), message.revision, network.revision()));
}

template <typename T>
T entry(const nlohmann::json& object, const char* key) {
  try {
    return exactly<T>(object.at(key));
  } catch (const nlohmann::json::exception&) {
    throw ProtocolError(fmt::format("entry {} is missing or of another type", key));
  }
}

Ledger read_ledger(const nlohmann::json& object) {
  Ledger ledger;
  ledger.injected = entry<double>(object, "injected");
  ledger.in_place = entry<double>(object, "in_place");
  if (object.contains("found")) ledger.found = entry<double>(object, "found");
  ledger.in_fractures = entry<double>(object, "in_fractures");
  ledger.leaked = entry<double>(object, "leaked");
  ledger.reset = entry<double>(object, "reset");
  ledger.residual =
      ledger.injected + ledger.in_place + ledger.found + ledger.reset - ledger.in_fractures - ledger.leaked;
  ledger.relative_residual = relative_residual(ledger);
  return ledger;
}

NaturalFractureFigures read_natural_fractures(const nlohmann::json& object) {
  NaturalFractureFigures figures;
  figures.greatest_slip = entry<double>(object, "greatest_slip");
  figures.slipped_length = entry<double>(object, "slipped_length");
  figures.opened_length = entry<double>(object, "opened_length");
  figures.wetted_length = entry<double>(object, "wetted_length");
  figures.slip_distance = entry<double>(object, "slip_distance");
  figures.greatest_far_slip = entry<double>(object, "greatest_far_slip");
  return figures;
}

}  // namespace

double relative_residual(const Ledger& ledger) {
  const double largest = std::max(
      {std::abs(ledger.injected), ledger.in_place, ledger.found, ledger.in_fractures, ledger.leaked});
  return largest > 0 ? std::abs(ledger.residual) / largest : 0;
}

StructureResponse read_response(const Message& message, const FractureNetwork& network,
                                const PressureRange& range) {
  if (message.type != MessageType::topology) require_revision(message, network);
  const Range pressure{range.minimum, range.maximum};
  StructureResponse response;
  response.aperture = numbers_in(message, "aperture", network, possible_aperture);
  response.aperture_rate = message.numbers("aperture_rate", network.nodes().size());
  response.pressure_applied = numbers_in(message, "pressure_applied", network, pressure);
  response.pressure_opening = message.numbers("pressure_opening", network.nodes().size());
  response.closed = numbers_in(message, "closed", network, flag);
  response.broken = numbers_in(message, "broken", network, flag);
  if (message.has("arm_aperture_a") || message.has("arm_aperture_b")) {
    response.arm_aperture_a = arm_apertures_in(message, "arm_aperture_a", network);
    response.arm_aperture_b = arm_apertures_in(message, "arm_aperture_b", network);
  }
  response.stable_step = message.value<double>("stable_step");
  response.mass_scale = message.value<double>("mass_scale");
  if (!(response.stable_step > 0) || !(response.mass_scale >= 1))
    throw ValueError(fmt::format("stable step {} s and mass scale {} are impossible", response.stable_step,
                                 response.mass_scale));
  if (message.type != MessageType::response) return response;
  response.steps = message.value<int>("steps");
  const auto energy = message.value<nlohmann::json>("energy");
  response.kinetic_energy = entry<double>(energy, "kinetic");
  if (energy.contains("strain")) response.strain_energy = entry<double>(energy, "strain");
  if (energy.contains("cohesive")) response.cohesive_work = entry<double>(energy, "cohesive");
  if (energy.contains("failure")) response.failure_work = entry<double>(energy, "failure");
  if (message.body.contains("elements")) response.elements = message.value<std::uint64_t>("elements");
  if (message.body.contains("natural_fractures"))
    response.natural_fractures = read_natural_fractures(message.body["natural_fractures"]);
  if (message.body.contains("probes"))
    for (const nlohmann::json& probe : message.body["probes"])
      response.probes.push_back(probe_values_from_json(probe));
  response.sources = records_of(message.arrays);
  if (message.body.contains("sources_merged"))
    response.sources_merged = message.value<std::uint64_t>("sources_merged");
  if (message.body.contains("transfer_moment"))
    response.transfer_moment = message.value<PlaneTensor>("transfer_moment");
  if (const auto proposal = message.body.find("insertion"); proposal != message.body.end())
    response.proposal = insertion_from_json(*proposal);
  return response;
}

std::vector<Remeshing> read_remeshing(const Message& acknowledgement) {
  std::vector<Remeshing> entries;
  const auto found = acknowledgement.body.find("remeshing");
  if (found == acknowledgement.body.end()) return entries;
  for (const nlohmann::json& object : *found) entries.push_back(remeshing_from_json(object));
  return entries;
}

std::vector<Meeting> read_meetings(const Message& acknowledgement) {
  std::vector<Meeting> meetings;
  const auto found = acknowledgement.body.find("meetings");
  if (found == acknowledgement.body.end()) return meetings;
  for (const nlohmann::json& object : *found) meetings.push_back(meeting_from_json(object));
  return meetings;
}

NetworkAnswer read_pressure(const Message& message, const FractureNetwork& network,
                            const PressureRange& range) {
  require_revision(message, network);
  NetworkAnswer answer;
  answer.pressure = numbers_in(message, "pressure", network, {range.minimum, range.maximum});
  answer.aperture_predicted = numbers_in(message, "aperture_predicted", network, possible_aperture);
  answer.filled = numbers_in(message, "filled", network, {0, 1 + fraction_slack});
  answer.ledger = read_ledger(message.value<nlohmann::json>("ledger"));
  answer.well_pressure = message.value<double>("well_pressure");
  answer.rate = message.value<double>("rate");
  const auto newton = message.value<nlohmann::json>("newton");
  answer.newton_iterations = entry<int>(newton, "iterations");
  answer.halvings = entry<int>(newton, "halvings");
  if (!entry<bool>(newton, "converged"))
    throw SolverError("the network sent pressures that have not converged");
  return answer;
}

}  // namespace fissura::coupler
