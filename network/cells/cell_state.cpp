// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/cells/cell_state.hpp"

#include <cmath>

#include "common/byte_archive.hpp"

namespace fissura::cells {

auto parts(EitherOf<CellState> auto& s) {
  return std::tie(s.time, s.started, s.content, s.pressure, s.filled, s.leaked, s.sweep, s.contact_pressure,
                  s.joining, s.aperture, s.segment, s.flux, s.well_pressure, s.rate, s.stage, s.stage_entry,
                  s.in_place, s.found, s.injected, s.leaked_in_all, s.reset);
}

void LongSum::add(double term) {
  const double total = sum + term;
  correction += std::abs(sum) >= std::abs(term) ? (sum - total) + term : (term - total) + sum;
  sum = total;
}

std::vector<std::byte> bytes_of(const CellState& state) {
  ByteWriter bytes;
  bytes.put(state);
  return bytes.take();
}

CellState state_from(std::span<const std::byte> bytes, std::size_t nodes, std::size_t segments,
                     std::size_t stages) {
  ByteReader reader(bytes);
  CellState state;
  reader.get(state);
  reader.end();
  for (const auto* values : {&state.content, &state.pressure, &state.filled, &state.leaked,
                             &state.contact_pressure, &state.aperture})
    ByteReader::require(values->size() == nodes);
  ByteReader::require(state.sweep.size() == nodes && state.segment.size() == segments &&
                      state.flux.size() == segments && state.joining.size() == nodes &&
                      (!state.stage || *state.stage < stages));
  return state;
}

}  // namespace fissura::cells
