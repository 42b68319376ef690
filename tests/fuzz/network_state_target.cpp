// SPDX-License-Identifier: GPL-3.0-or-later
// The flow solver's state in a checkpoint, once as it is and once under a right checksum: restored, or refused whole; what was restored can be computed with
// and saved.
#include "common/case/case_json.hpp"
#include "tests/fuzz/judged.hpp"
#include "tests/fuzz/sample_network.hpp"
#include "tests/network/messaged_network.hpp"

using namespace fissura;

namespace {

constexpr std::size_t largest_input = 16384;

void use(const FractureNetwork& network, double time, network::test::MessagedNetwork& solver) {
  const std::vector<std::byte> saved = solver.save();
  network::test::MessagedNetwork again;
  again.join({case_to_json(fuzz::water_case()), 1, true});
  (void)again.restore(saved);
  MUST_HOLD(again.save() == saved);
  fuzz::take_or_refuse([&] { (void)solver.report(Message(MessageType::report)); });
  fuzz::take_or_refuse([&] { (void)solver.advance(fuzz::advance_message(network, time, time + 0.1)); });
}

StateOwner owner() {
  network::test::MessagedNetwork solver;
  solver.join({case_to_json(fuzz::water_case()), 1, true});
  return solver.owner();
}

void restore(const std::vector<std::byte>& bytes) {
  network::test::MessagedNetwork solver;
  solver.join({case_to_json(fuzz::water_case()), 1, true});
  (void)solver.restore(bytes);
  Message state(MessageType::state);
  solver.describe_neutral_state(state);
  use(solver.network(), state.body["neutral"]["time"].get<double>(), solver);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > largest_input) return 0;
  fuzz::take_or_refuse([&] { restore(fuzz::copied(data, size)); });
  static const StateOwner of_water = owner();
  fuzz::take_or_refuse([&] { restore(fuzz::as_state_of(of_water, fuzz::bytes_of(data, size))); });
  return 0;
}
