// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/checkpoint.hpp"

#include "common/byte_archive.hpp"
#include "common/errors.hpp"

namespace fissura::network {

constexpr Front last_of(Front) {
  return Front::passed;
}

auto parts(EitherOf<Exposure> auto& exposure) {
  return std::tie(exposure.begin, exposure.end, exposure.residence, exposure.front);
}

auto parts(EitherOf<State> auto& state) {
  return std::tie(state.time, state.started, state.content, state.pressure, state.filled, state.leaked,
                  state.waived, state.has_been_filled, state.exposure, state.joining, state.pore_content,
                  state.arrived, state.contact_pressure, state.fluid_fraction, state.flux, state.gradient,
                  state.perforation_rate, state.well_pressure, state.rate, state.stage, state.stage_entry,
                  state.ledger);
}

auto parts(EitherOf<Checkpoint> auto& checkpoint) {
  return std::tie(checkpoint.state, checkpoint.aperture, checkpoint.figures);
}

namespace {

void require_of(const Graph& graph, const Model& model, const Checkpoint& checkpoint) {
  const State& state = checkpoint.state;
  const std::size_t nodes = graph.node_count(), segments = graph.segment_count();
  for (const auto* values : {&state.content, &state.pressure, &state.filled, &state.leaked, &state.waived,
                             &state.pore_content, &state.arrived, &state.contact_pressure})
    ByteReader::require(values->size() == nodes);
  for (const auto* flags : {&state.has_been_filled, &state.joining})
    ByteReader::require(flags->size() == nodes);
  ByteReader::require(
      state.exposure.size() == nodes && state.fluid_fraction.size() == nodes * model.fluids.size() &&
      state.flux.size() == segments && state.gradient.size() == segments &&
      state.perforation_rate.size() == graph.perforations().size() && checkpoint.aperture.size() <= nodes &&
      (!state.stage || *state.stage < model.schedule.stages().size()));
}

}  // namespace

std::vector<std::byte> checkpoint_to_bytes(const Checkpoint& checkpoint) {
  ByteWriter bytes;
  bytes.put(checkpoint);
  return bytes.take();
}

Checkpoint checkpoint_from_bytes(std::span<const std::byte> bytes, const Graph& graph, const Model& model) {
  ByteReader reader(bytes);
  Checkpoint checkpoint;
  reader.get(checkpoint);
  reader.end();
  require_of(graph, model, checkpoint);
  return checkpoint;
}

}  // namespace fissura::network
