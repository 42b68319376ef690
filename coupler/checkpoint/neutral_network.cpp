// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/checkpoint/neutral_network.hpp"

#include <cstdint>

#include "common/byte_archive.hpp"

namespace fissura {

auto parts(EitherOf<NeutralFlowState> auto& state) {
  return std::tie(state.time, state.started, state.content, state.pressure, state.leaked, state.exposure_time,
                  state.contact_pressure, state.fluid_fraction, state.joining, state.well_pressure,
                  state.rate, state.entry_rate, state.entry_pressure, state.ledger);
}

namespace coupler {

namespace {

constexpr std::uint64_t format = 1;

}  // namespace

std::vector<std::byte> neutral_part(const NeutralFlowState& state) {
  ByteWriter bytes;
  bytes.put(format);
  bytes.put(state);
  return bytes.take();
}

NeutralFlowState neutral_state_of(std::span<const std::byte> part, std::size_t nodes, std::size_t fluids) {
  ByteReader bytes(part);
  std::uint64_t found_format = 0;
  NeutralFlowState state;
  bytes.get(found_format);
  ByteReader::require(found_format == format);
  bytes.get(state);
  bytes.end();
  for (const std::size_t size :
       {state.content.size(), state.pressure.size(), state.leaked.size(), state.exposure_time.size(),
        state.contact_pressure.size(), state.joining.size()})
    ByteReader::require(size == nodes);
  ByteReader::require(state.fluid_fraction.size() == nodes * fluids);
  return state;
}

}  // namespace coupler

}  // namespace fissura
