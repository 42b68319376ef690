// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/tape/network_places.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/fracture_network/insertion_json.hpp"
#include "coupler/tape/message_difference.hpp"

namespace fissura::coupler {

namespace {

nlohmann::json body_of(const Frames& message) {
  if (message.size() < 2) return {};
  const auto* text = reinterpret_cast<const char*>(message[1].data());
  return nlohmann::json::parse(text, text + message[1].size(), nullptr, false);
}

std::uint64_t rows_of(const nlohmann::json& body, const std::string& array) {
  if (body.is_object() && body.contains("arrays"))
    for (const auto& each : body["arrays"])
      if (each.value("name", "") == array && !each.value("shape", nlohmann::json::array()).empty())
        return each["shape"][0].get<std::uint64_t>();
  return 0;
}

}  // namespace

void NetworkPlaces::follow(const Frames& message) {
  const MessageType type = envelope_of(message).type;
  if (type != MessageType::insert && type != MessageType::restore) return;
  const nlohmann::json body = body_of(message);
  try {
    if (type == MessageType::insert) {
      network_.apply(insertion_from_json(body.at("insertion")));
      return;
    }
    network_ = {};
    for (const auto& insertion : body.at("insertions")) network_.apply(insertion_from_json(insertion));
  } catch (const nlohmann::json::exception&) {
    network_ = {};
  } catch (const Error&) {
    network_ = {};
  }
}

std::string NetworkPlaces::place(const Frames& message, const std::string& array, std::uint64_t row) const {
  const std::uint64_t rows = rows_of(body_of(message), array);
  const bool of_arm = array.starts_with("arm_");
  if (rows == network_.nodes().size() && row < rows && !of_arm) {
    const NetworkNode& node = network_.nodes()[row];
    return fmt::format("node {} at ({}, {}) m", node.id, node.x, node.y);
  }
  if (rows == network_.segments().size() && row < rows) {
    const NetworkSegment& segment = network_.segments()[row];
    return fmt::format("segment {} between nodes {} and {}", segment.id, segment.node_a, segment.node_b);
  }
  return {};
}

}  // namespace fissura::coupler
