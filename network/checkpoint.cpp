// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/checkpoint.hpp"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/fracture_network/insertion_json.hpp"

namespace fissura::network {

namespace {

using nlohmann::json;

constexpr int version = 2;

/// Numbers travel as raw bytes: compact, and no infinity or signed zero is a special case.
template <typename T>
json packed(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return json::binary(std::move(bytes));
}

template <typename T>
std::vector<T> unpacked(const json& entry) {
  const auto& bytes = entry.get_binary();
  if (bytes.size() % sizeof(T) != 0)
    throw Error(ExitCode::checkpoint_unusable, "an array of the network's checkpoint has a broken length");
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

std::vector<double> scalars_of(const State& state) {
  return {state.time,
          state.well_pressure,
          state.rate,
          state.stage_entry.rate,
          state.stage_entry.pressure,
          state.ledger.in_place,
          state.ledger.found.sum,
          state.ledger.found.correction,
          state.ledger.injected.sum,
          state.ledger.injected.correction,
          state.ledger.leaked.sum,
          state.ledger.leaked.correction,
          state.ledger.reset.sum,
          state.ledger.reset.correction};
}

void set_scalars(const std::vector<double>& values, State& state) {
  double* const places[] = {&state.time,
                            &state.well_pressure,
                            &state.rate,
                            &state.stage_entry.rate,
                            &state.stage_entry.pressure,
                            &state.ledger.in_place,
                            &state.ledger.found.sum,
                            &state.ledger.found.correction,
                            &state.ledger.injected.sum,
                            &state.ledger.injected.correction,
                            &state.ledger.leaked.sum,
                            &state.ledger.leaked.correction,
                            &state.ledger.reset.sum,
                            &state.ledger.reset.correction};
  if (values.size() != std::size(places))
    throw Error(ExitCode::checkpoint_unusable, "the network's checkpoint has another number of scalars");
  for (std::size_t k = 0; k < values.size(); ++k) *places[k] = values[k];
}

json exposure_to_json(const std::vector<Exposure>& exposures) {
  std::vector<double> times;
  std::vector<std::uint8_t> fronts;
  for (const Exposure& exposure : exposures) {
    times.insert(times.end(), {exposure.begin, exposure.end, exposure.residence});
    fronts.push_back(static_cast<std::uint8_t>(exposure.front));
  }
  return {{"times", packed(times)}, {"fronts", packed(fronts)}};
}

std::vector<Exposure> exposure_from_json(const json& entry) {
  const auto times = unpacked<double>(entry.at("times"));
  const auto fronts = unpacked<std::uint8_t>(entry.at("fronts"));
  if (times.size() != 3 * fronts.size())
    throw Error(ExitCode::checkpoint_unusable,
                "the exposure times of the network's checkpoint do not fit together");
  std::vector<Exposure> exposures;
  for (std::size_t i = 0; i < fronts.size(); ++i)
    exposures.push_back({times[3 * i], times[3 * i + 1], times[3 * i + 2], static_cast<Front>(fronts[i])});
  return exposures;
}

json state_to_json(const State& state) {
  return {{"scalars", packed(scalars_of(state))},
          {"started", state.started},
          {"stage", state.stage ? json(*state.stage) : json()},
          {"content", packed(state.content)},
          {"pressure", packed(state.pressure)},
          {"filled", packed(state.filled)},
          {"leaked", packed(state.leaked)},
          {"waived", packed(state.waived)},
          {"has_been_filled", packed(state.has_been_filled)},
          {"exposure", exposure_to_json(state.exposure)},
          {"joining", packed(state.joining)},
          {"pore_content", packed(state.pore_content)},
          {"arrived", packed(state.arrived)},
          {"contact_pressure", packed(state.contact_pressure)},
          {"fluid_fraction", packed(state.fluid_fraction)},
          {"flux", packed(state.flux)},
          {"gradient", packed(state.gradient)},
          {"perforation_rate", packed(state.perforation_rate)}};
}

State state_from_json(const json& entry) {
  State state;
  set_scalars(unpacked<double>(entry.at("scalars")), state);
  state.started = entry.at("started").get<bool>();
  if (!entry.at("stage").is_null()) state.stage = entry.at("stage").get<std::size_t>();
  state.content = unpacked<double>(entry.at("content"));
  state.pressure = unpacked<double>(entry.at("pressure"));
  state.filled = unpacked<double>(entry.at("filled"));
  state.leaked = unpacked<double>(entry.at("leaked"));
  state.waived = unpacked<double>(entry.at("waived"));
  state.has_been_filled = unpacked<unsigned char>(entry.at("has_been_filled"));
  state.exposure = exposure_from_json(entry.at("exposure"));
  state.joining = unpacked<unsigned char>(entry.at("joining"));
  state.pore_content = unpacked<double>(entry.at("pore_content"));
  state.arrived = unpacked<double>(entry.at("arrived"));
  state.contact_pressure = unpacked<double>(entry.at("contact_pressure"));
  state.fluid_fraction = unpacked<double>(entry.at("fluid_fraction"));
  state.flux = unpacked<double>(entry.at("flux"));
  state.gradient = unpacked<double>(entry.at("gradient"));
  state.perforation_rate = unpacked<double>(entry.at("perforation_rate"));
  return state;
}

}  // namespace

std::vector<std::byte> checkpoint_to_bytes(const Checkpoint& checkpoint) {
  json history = json::array();
  for (const Insertion& insertion : checkpoint.history) history.push_back(insertion_to_json(insertion));
  const std::vector<std::uint8_t> bytes = json::to_cbor(
      {{"version", version}, {"history", std::move(history)}, {"state", state_to_json(checkpoint.state)}});
  const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
  return {first, first + bytes.size()};
}

Checkpoint checkpoint_from_bytes(std::span<const std::byte> bytes) {
  try {
    const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    const json document = json::from_cbor(first, first + bytes.size());
    const int found = document.at("version").get<int>();
    if (found != version)
      throw Error(ExitCode::checkpoint_unusable,
                  fmt::format("the network's checkpoint has version {}, expected {}", found, version));
    Checkpoint checkpoint;
    for (const json& insertion : document.at("history"))
      checkpoint.history.push_back(insertion_from_json(insertion));
    checkpoint.state = state_from_json(document.at("state"));
    return checkpoint;
  } catch (const json::exception& fault) {
    throw Error(ExitCode::checkpoint_unusable,
                fmt::format("the network's checkpoint cannot be read: {}", fault.what()));
  }
}

}  // namespace fissura::network
