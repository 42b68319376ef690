// SPDX-License-Identifier: GPL-3.0-or-later
// A JSON list of insertions, as INSERT and RESTORE bring it, given to a network and to the flow solver; what
// the solver took, it must be able to compute with, save and restore.
#include "common/case/case_json.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "tests/fuzz/judged.hpp"
#include "tests/fuzz/sample_network.hpp"
#include "tests/network/messaged_network.hpp"

using namespace fissura;

namespace {

constexpr std::size_t largest_input = 16384;

void insert_all(const nlohmann::json& list, FractureNetwork& network, network::test::MessagedNetwork& solver) {
  for (const nlohmann::json& entry : list) {
    const Insertion insertion = insertion_from_json(entry);
    MUST_HOLD(insertion_from_json(insertion_to_json(insertion)) == insertion);
    network.apply(insertion);
    MUST_HOLD(solver.insert(insertion) == network.topology_hash());
  }
}

void use(const FractureNetwork& network, network::test::MessagedNetwork& solver) {
  static const nlohmann::json run_case = case_to_json(fuzz::water_case());
  const std::vector<std::byte> saved = solver.save();
  fuzz::take_or_refuse([&] { (void)solver.advance(fuzz::advance_message(network, 0, 0.1)); });
  fuzz::take_or_refuse([&] { (void)solver.report(Message(MessageType::report)); });
  network::test::MessagedNetwork other;
  other.join({run_case, 1, true});
  (void)other.restore(saved);
  MUST_HOLD(other.save() == saved);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > largest_input) return 0;
  const nlohmann::json list = nlohmann::json::parse(data, data + size, nullptr, false);
  if (list.is_discarded()) return 0;
  FractureNetwork network;
  network::test::MessagedNetwork solver;
  solver.join({case_to_json(fuzz::water_case()), 1, false});
  fuzz::take_or_refuse([&] { insert_all(list, network, solver); });
  if (!network.empty()) use(network, solver);
  return 0;
}
