// SPDX-License-Identifier: GPL-3.0-or-later
#include <arpa/inet.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <regex>
#include <string>

#include "common/case/sections.hpp"
#include "common/case/shipped_flow_solvers.hpp"

namespace fissura::input {

namespace {

/// The places of the shipped flow solvers, by their names.
constexpr auto network_solvers = [] {
  std::array<Named<std::size_t>, shipped_flow_solvers.size()> names{};
  for (std::size_t k = 0; k < names.size(); ++k) names[k] = {shipped_flow_solvers[k].name, k};
  return names;
}();

/// "ipc", or TCP at an address in figures: a name could mean another machine tomorrow.
bool is_endpoint(const std::string& endpoint) {
  static const std::regex form(R"(ipc|tcp://([0-9.]+|\[[0-9a-fA-F:.]+\]):([0-9]{1,5}|\*))");
  std::smatch part;
  if (!std::regex_match(endpoint, part, form)) return false;
  if (endpoint == "ipc") return true;
  const std::string address = part[1], port = part[2];
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  const bool is_version_4 = ::inet_pton(AF_INET, address.c_str(), bytes.data()) == 1;
  const bool is_version_6 =
      address.size() > 2 &&
      ::inet_pton(AF_INET6, address.substr(1, address.size() - 2).c_str(), bytes.data()) == 1;
  return (is_version_4 || is_version_6) &&
         (port == "*" || std::stoi(port) <= std::numeric_limits<std::uint16_t>::max());
}

}  // namespace

Exchange read_exchange(TableReader& document) {
  TableReader table = document.optional_table("exchange");
  Exchange exchange;
  exchange.endpoint = table.text("endpoint", exchange.endpoint);
  if (!exchange.endpoint.empty() && !is_endpoint(exchange.endpoint))
    table.refuse("endpoint",
                 "\"ipc\" or an address in figures with a port, such as \"tcp://127.0.0.1:*\" or "
                 "\"tcp://192.0.2.7:5555\"");
  table.refuse_unknown_keys();
  return exchange;
}

Participants read_participants(TableReader& document) {
  TableReader table = document.optional_table("participants");
  Participants participants;
  if (const auto chosen = table.has("network") ? table.choice("network", network_solvers) : std::nullopt)
    participants.network = shipped_flow_solvers[*chosen].name;
  table.refuse_unknown_keys();
  return participants;
}

}  // namespace fissura::input
