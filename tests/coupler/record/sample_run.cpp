// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/coupler/record/sample_run.hpp"

#include <algorithm>
#include <cstring>

namespace fissura::coupler::sample {

std::vector<double> doubles(const Array& array) {
  std::vector<double> values(array.bytes.size() / sizeof(double));
  std::memcpy(values.data(), array.bytes.data(), array.bytes.size());
  return values;
}

FractureNetwork network() {
  Insertion first;
  first.new_nodes = {{10, -1, 0, 0.5, 1, NodeRole::tip, 0},
                     {11, 0, 0, 1.0, 1, NodeRole::perforation, 0},
                     {12, 1, 0, 0.5, 1, NodeRole::tip, 0}};
  first.new_segments = {{20, 10, 11, 1, SegmentKind::hydraulic, 1.0},
                        {21, 11, 12, 1, SegmentKind::hydraulic, 1.0}};
  FractureNetwork result;
  result.apply(first);
  return result;
}

FractureNetwork grown_network() {
  Insertion growth;
  growth.revision = 1;
  growth.updated_nodes = {{12, 1, 0, 1.0, 1, NodeRole::interior, 0}};
  growth.new_nodes = {{13, 2, 0, 0.5, 1, NodeRole::tip, 0.5}};
  growth.new_segments = {{22, 12, 13, 1, SegmentKind::hydraulic, 1.0}};
  FractureNetwork result = network();
  result.apply(growth);
  return result;
}

Message structure_fields(double time, std::uint64_t geometry, std::uint64_t extra_nodes) {
  const std::uint64_t nodes = 4 + extra_nodes;
  std::vector<double> position{0, 0, 1, 0, 1, 1, 0, 1}, displacement;
  for (std::uint64_t extra = 0; extra < extra_nodes; ++extra)
    position.insert(position.end(), {2.0 + double(extra), 0.5});
  for (std::uint64_t node = 0; node < nodes; ++node)
    displacement.insert(displacement.end(), {double(node) + time, 10 * double(node) + time});
  std::vector<std::uint64_t> elements{0, 1, 2, 0, 2, 3};
  for (std::uint64_t extra = 0; extra < extra_nodes; ++extra)
    elements.insert(elements.end(), {1, 4 + extra, 2});
  const std::uint64_t element_count = elements.size() / 3;
  const std::vector<double> stress(element_count * 4, -1e7);

  Message fields(MessageType::fields);
  fields.body["geometry"] = geometry;
  fields.add("position", "m", position, nodes, 2);
  fields.add_ids("elements", elements, 3);
  fields.add("displacement", "m", displacement, nodes, 2);
  fields.add("stress", "Pa", stress, element_count, 4);
  return fields;
}

Message without_mesh(Message fields) {
  std::erase_if(fields.arrays,
                [](const Array& array) { return array.name == "position" || array.name == "elements"; });
  return fields;
}

Message with_joints(Message fields, double time) {
  fields.add("joint_position", "m", std::vector<double>{0.25, 0.5, 0.75, 0.5}, 2, 2);
  fields.add("joint_normal", "1", std::vector<double>{0, 1, 0.6, 0.8}, 2, 2);
  fields.add("joint_slip", "m", std::vector<double>{time, -time});
  fields.add_bytes("joint_kind", std::vector<std::byte>{std::byte{1}, std::byte{0}});
  return fields;
}

Message network_fields(const FractureNetwork& network) {
  Message fields(MessageType::fields);
  fields.add("content", "m", std::vector<double>(network.nodes().size(), 1e-4));
  return fields;
}

std::vector<NodeField> node_fields(const FractureNetwork& network, double time) {
  std::vector<double> aperture, pressure;
  for (std::size_t node = 0; node < network.nodes().size(); ++node) {
    aperture.push_back(1e-4 * double(node + 1) + time);
    pressure.push_back(1e6 * double(node + 1));
  }
  return {{"aperture", "m", aperture}, {"pressure", "Pa", pressure}};
}

IntervalRecord interval(std::uint64_t number, double time) {
  IntervalRecord record;
  record.interval = number;
  record.revision = 3;
  record.time = time;
  record.duration = 0.1;
  record.explicit_steps = 17;
  record.half_length = 5 + time;
  record.half_length_open = 5.5 + time;
  record.half_length_broken = 4.5 + time;
  record.inlet_aperture = 1.0 / 3;
  record.inlet_pressure = 31e6;
  record.inlet_net_pressure = 1e6;
  record.well_pressure = 32e6;
  record.rate = 2e-3;
  record.ledger = {1e-3, 2e-6, 5e-6, 9e-4, 1e-4, 3e-9, 1e-19, 1e-16};
  record.efficiency = 0.875;
  record.mismatch = 2e-4;
  record.drift = 3e-4;
  record.newton_iterations = 4;
  record.halvings = 1;
  record.kinetic_energy = 12;
  record.strain_energy = 1200;
  record.cohesive_work = 480;
  record.failure_work = 35;
  record.cohesive_share = 0.97;
  record.path_deviation = 0.21;
  record.path_angle = 0.02;
  record.first_angle = 0.05;
  record.end_angle = 0.07;
  record.natural_fractures = {2.5e-4, 6, 1.25, 7, 1.5, 8e-6};
  record.meetings = 9;
  record.crossings = 5;
  record.junction_pressure = 30e6;
  record.seismicity = {21, 3.5e7, 1.5e7, 8e8, 2e5, {1e8, -2e8, 4e7, 6e6}};
  record.elements = 7000;
  record.mass_scale = 250;
  record.stable_step = 1e-5;
  return record;
}

}  // namespace fissura::coupler::sample
