// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/record/field_arrays.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>

#include "common/errors.hpp"

namespace fissura::coupler {

namespace {

bool is_plain_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '_';
  });
}

bool has_bytes_of_its_shape(const Array& array) {
  const bool known =
      array.dtype == "float64" || array.dtype == "int64" || array.dtype == "uint64" || array.dtype == "uint8";
  if (!known || array.shape.empty()) return false;
  std::uint64_t count = array.dtype == "uint8" ? 1 : 8;
  for (const std::uint64_t extent : array.shape) count *= extent;
  return array.bytes.size() == count;
}

void check_array(const Array& array, std::string_view participant) {
  if (!is_plain_name(array.name))
    throw ProtocolError(
        fmt::format("a field of the {} is named \"{}\"; letters, digits and underscores were expected",
                    participant, array.name));
  if (!has_bytes_of_its_shape(array))
    throw ProtocolError(
        fmt::format("the field \"{}\" of the {} ({}, shape {}) has {} bytes, which do not fit", array.name,
                    participant, array.dtype, array.shape, array.bytes.size()));
}

}  // namespace

SortedFields sort_fields(const Message& message, std::string_view participant, std::uint64_t nodes,
                         std::uint64_t cells, const std::vector<std::string_view>& geometry_names) {
  SortedFields sorted;
  std::set<std::string_view> seen;
  for (const Array& array : message.arrays) {
    check_array(array, participant);
    if (!seen.insert(array.name).second)
      throw ProtocolError(fmt::format("the field \"{}\" of the {} comes twice", array.name, participant));
    if (std::find(geometry_names.begin(), geometry_names.end(), array.name) != geometry_names.end()) continue;
    if (array.shape[0] == nodes) {
      sorted.nodes.push_back(&array);
    } else if (array.shape[0] == cells) {
      sorted.cells.push_back(&array);
    } else {
      throw ProtocolError(
          fmt::format("the field \"{}\" of the {} has {} rows; {} (nodes) or {} (cells) were expected",
                      array.name, participant, array.shape[0], nodes, cells));
    }
  }
  return sorted;
}

std::vector<Array> take_joint_arrays(Message& message, std::string_view participant) {
  constexpr std::string_view prefix = "joint_";
  Message joints(MessageType::fields);
  for (const Array& array : message.arrays)
    if (array.name.starts_with(prefix)) joints.arrays.push_back(array);
  if (joints.arrays.empty()) return {};
  std::erase_if(message.arrays, [&](const Array& array) { return array.name.starts_with(prefix); });
  const std::uint64_t units = require_table(joints, participant, "joint_position", "float64", 2).shape[0];
  (void)sort_fields(joints, participant, units, units, {});
  for (Array& array : joints.arrays) array.name.erase(0, prefix.size());
  return joints.arrays;
}

Message topology_arrays(const FractureNetwork& network) {
  std::vector<double> position, lumped_length, exposure_time;
  std::vector<std::uint64_t> id, fracture, role, ends, segment_id, segment_fracture, kind;
  for (const NetworkNode& node : network.nodes()) {
    position.insert(position.end(), {node.x, node.y});
    lumped_length.push_back(node.lumped_length);
    exposure_time.push_back(node.exposure_time);
    id.push_back(node.id);
    fracture.push_back(node.fracture);
    role.push_back(static_cast<std::uint64_t>(node.role));
  }
  for (const NetworkSegment& segment : network.segments()) {
    ends.insert(ends.end(), {network.index_of(segment.node_a), network.index_of(segment.node_b)});
    segment_id.push_back(segment.id);
    segment_fracture.push_back(segment.fracture);
    kind.push_back(static_cast<std::uint64_t>(segment.kind));
  }
  Message arrays(MessageType::fields);
  arrays.add("position", "m", position, network.nodes().size(), 2);
  arrays.add("lumped_length", "m", lumped_length);
  arrays.add("exposure_time", "s", exposure_time);
  arrays.add_ids("id", id);
  arrays.add_ids("fracture", fracture);
  arrays.add_ids("role", role);
  arrays.add_ids("segments", ends, 2);
  arrays.add_ids("segment_id", segment_id);
  arrays.add_ids("segment_fracture", segment_fracture);
  arrays.add_ids("segment_kind", kind);
  return arrays;
}

const Array& require_table(const Message& message, std::string_view participant, std::string_view name,
                           std::string_view dtype, std::uint64_t columns) {
  const auto found = std::find_if(message.arrays.begin(), message.arrays.end(),
                                  [&](const Array& array) { return array.name == name; });
  if (found == message.arrays.end())
    throw ProtocolError(fmt::format("the FIELDS of the {} lack \"{}\"", participant, name));
  check_array(*found, participant);
  if (found->dtype != dtype || found->shape.size() != 2 || found->shape[1] != columns)
    throw ProtocolError(
        fmt::format("the field \"{}\" of the {} is {} of shape {}; {} with {} columns was expected", name,
                    participant, found->dtype, found->shape, dtype, columns));
  return *found;
}

Array with_zero_third_column(const Array& array) {
  ENSURE(array.dtype == "float64" && array.shape.size() == 2 && array.shape[1] == 2);
  const std::uint64_t rows = array.shape[0];
  Array vectors{
      array.name, array.dtype, {rows, 3}, array.unit, std::vector<std::byte>(rows * 3 * sizeof(double))};
  for (std::uint64_t row = 0; row < rows; ++row)
    std::memcpy(vectors.bytes.data() + row * 3 * sizeof(double),
                array.bytes.data() + row * 2 * sizeof(double), 2 * sizeof(double));
  return vectors;
}

}  // namespace fissura::coupler
