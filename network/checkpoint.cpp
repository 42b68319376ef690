// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/checkpoint.hpp"

#include "common/byte_archive.hpp"
#include "common/case/case_hash.hpp"
#include "common/errors.hpp"
#include "common/fracture_network/insertion_archive.hpp"

namespace fissura::network {

namespace {

constexpr std::uint64_t format = 3;

}  // namespace

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
  return std::tie(checkpoint.history, checkpoint.state, checkpoint.aperture, checkpoint.figures);
}

StateOwner network_owner(const Case& run_case) {
  return {"network", "Fissura " FISSURA_VERSION, format, case_hash(run_case)};
}

std::vector<std::byte> checkpoint_to_bytes(const StateOwner& owner, const Checkpoint& checkpoint) {
  ByteWriter bytes;
  begin_state(owner, bytes);
  bytes.put(checkpoint);
  return end_state(bytes);
}

Checkpoint checkpoint_from_bytes(std::span<const std::byte> bytes, const StateOwner& owner) {
  ByteReader reader(state_inside(bytes, owner));
  Checkpoint checkpoint;
  reader.get(checkpoint);
  reader.end();
  return checkpoint;
}

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

}  // namespace fissura::network
