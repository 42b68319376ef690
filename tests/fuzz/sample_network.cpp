// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/sample_network.hpp"

#include "common/fracture_network/insertion_json.hpp"
#include "common/seismicity/source_record.hpp"

namespace fissura::fuzz {

Case water_case() {
  Case value;
  value.time.end = 10;
  value.domain = {100, 100, 2};
  value.fluids = {{"water", 1.67e-3, 1, 2e9}, {"gel", 0.5, 0.5, 2e9}};
  value.leak_off = {1e-5, 0};
  value.injection.well_index = 1e-5;
  value.injection.stages = {{.begin = 0, .rate = 2e-3, .fluid = "water"},
                            {.begin = 0.15, .rate = 2e-3, .fluid = "gel"}};
  value.network = {1e-5, 1e-10, 100};
  return value;
}

Insertion first_insertion(std::uint64_t nodes) {
  Insertion insertion;
  for (std::uint64_t id = 1; id <= nodes; ++id) {
    const bool end = id == 1 || id == nodes;
    insertion.new_nodes.push_back(
        {.id = id, .x = 0.5 * static_cast<double>(id), .lumped_length = end ? 0.25 : 0.5});
    if (id > 1)
      insertion.new_segments.push_back({.id = id - 1, .node_a = id - 1, .node_b = id, .length = 0.5});
  }
  insertion.new_perforations.push_back({"well", 3});
  return insertion;
}

Insertion growth(std::uint64_t nodes) {
  Insertion insertion;
  insertion.revision = 1;
  insertion.new_nodes.push_back({.id = nodes + 1,
                                 .x = 0.5 * static_cast<double>(nodes + 1),
                                 .lumped_length = 0.25,
                                 .role = NodeRole::tip,
                                 .exposure_time = 0.1});
  insertion.new_segments.push_back({.id = nodes, .node_a = nodes, .node_b = nodes + 1, .length = 0.5});
  insertion.parents.push_back({nodes + 1, nodes});
  return insertion;
}

FractureNetwork network_of(const Insertion& insertion) {
  FractureNetwork network;
  network.apply(insertion);
  return network;
}

PressureRange pressure_range() {
  return {-1e8, 1e9};
}

Message pressure_message(const FractureNetwork& network) {
  const std::size_t count = network.nodes().size();
  Message message(MessageType::pressure);
  message.interval = 4;
  message.revision = network.revision();
  message.body = {
      {"ledger",
       {{"injected", 1e-3}, {"in_place", 0.0}, {"in_fractures", 9e-4}, {"leaked", 1e-4}, {"reset", 0.0}}},
      {"well_pressure", 6e6},
      {"rate", 2e-3},
      {"newton", {{"iterations", 3}, {"halvings", 0}, {"converged", true}}}};
  message.add("pressure", "Pa", std::vector<double>(count, 5e6));
  message.add("aperture_predicted", "m", std::vector<double>(count, 1e-4));
  message.add("filled", "1", std::vector<double>(count, 0.5));
  return message;
}

Message response_message(const FractureNetwork& network) {
  const std::size_t count = network.nodes().size();
  Message message(MessageType::response);
  message.interval = 4;
  message.revision = network.revision();
  message.body = {{"stable_step", 1e-5}, {"mass_scale", 1.0},
                  {"steps", 20},         {"energy", {{"kinetic", 1.0}, {"strain", 2.0}}},
                  {"elements", 400},     {"insertion", insertion_to_json(growth(count))}};
  message.add("aperture", "m", std::vector<double>(count, 1e-4));
  message.add("aperture_rate", "m/s", std::vector<double>(count, 1e-6));
  message.add("pressure_applied", "Pa", std::vector<double>(count, 5e6));
  message.add("pressure_opening", "Pa", std::vector<double>(count, 1e6));
  message.add("closed", "1", std::vector<double>(count, 0.0));
  message.add("broken", "1", std::vector<double>(count, 1.0));
  SourceRecord record;
  record.entity = 7;
  record.end = 0.01;
  record.normal = {0, 1};
  record.moment = {1e6, 1e6, 5e5, 0};
  for (Array& array : arrays_of({record})) message.arrays.push_back(std::move(array));
  return message;
}

Message advance_message(const FractureNetwork& network, double begin, double end) {
  const std::size_t count = network.nodes().size();
  Message message(MessageType::advance);
  message.revision = network.revision();
  message.body = {{"begin", begin}, {"end", end}, {"carry", "content"}};
  message.add("aperture", "m", std::vector<double>(count, 1e-4));
  message.add("aperture_rate", "m/s", std::vector<double>(count, 0.0));
  message.add("reference_pressure", "Pa", std::vector<double>(count, 5e6));
  message.add("compliance", "m/Pa", std::vector<double>(count, 1e-10));
  message.add("closed", "1", std::vector<double>(count, 0.0));
  return message;
}

std::vector<std::byte> as_state_of(const StateOwner& owner, std::span<const std::byte> inside) {
  ByteWriter bytes;
  begin_state(owner, bytes);
  for (const std::byte value : inside) bytes.put(value);
  return end_state(bytes);
}

}  // namespace fissura::fuzz
