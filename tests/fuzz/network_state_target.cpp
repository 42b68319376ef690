// SPDX-License-Identifier: GPL-3.0-or-later
// The flow solver's state in a checkpoint, once as it is and once under a right checksum: restored, or refused whole; what was restored can be computed with
// and saved.
#include "common/case/case_json.hpp"
#include "common/fracture_network/insertion_archive.hpp"
#include "network/checkpoint.hpp"
#include "network/network_solver.hpp"
#include "tests/fuzz/judged.hpp"
#include "tests/fuzz/sample_network.hpp"

using namespace fissura;

namespace {

constexpr std::size_t largest_input = 16384;

void use(const FractureNetwork& network, double time, network::NetworkSolver& solver) {
  const std::vector<std::byte> saved = solver.save();
  network::NetworkSolver again;
  again.join({case_to_json(fuzz::water_case()), 1, true});
  again.restore(saved);
  MUST_HOLD(again.save() == saved);
  fuzz::take_or_refuse([&] { (void)solver.report(Message(MessageType::report)); });
  fuzz::take_or_refuse([&] { (void)solver.advance(fuzz::advance_message(network, time, time + 0.1)); });
}

StateOwner owner() {
  static const StateOwner of_water = network::network_owner(fuzz::water_case());
  return of_water;
}

void restore(const std::vector<std::byte>& bytes) {
  network::NetworkSolver solver;
  solver.join({case_to_json(fuzz::water_case()), 1, true});
  solver.restore(bytes);
  const network::Checkpoint checkpoint = network::checkpoint_from_bytes(bytes, owner());
  use(network_after(checkpoint.history), checkpoint.state.time, solver);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > largest_input) return 0;
  fuzz::take_or_refuse([&] { restore(fuzz::copied(data, size)); });
  fuzz::take_or_refuse([&] { restore(fuzz::as_state_of(owner(), fuzz::bytes_of(data, size))); });
  return 0;
}
