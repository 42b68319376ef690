// SPDX-License-Identifier: GPL-3.0-or-later
#include <regex>

#include "common/case/sections.hpp"

namespace fissura::input {

namespace {

enum class NetworkSolver { fissura };

constexpr std::array network_solvers{Named<NetworkSolver>{"fissura", NetworkSolver::fissura}};

bool is_safe(const std::string& endpoint) {
  static const std::regex safe(R"(ipc|tcp://(127(\.[0-9]{1,3}){3}|\[::1\]):([0-9]{1,5}|\*))");
  return std::regex_match(endpoint, safe);
}

}  // namespace

Exchange read_exchange(TableReader& document) {
  TableReader table = document.optional_table("exchange");
  Exchange exchange;
  exchange.endpoint = table.text("endpoint", exchange.endpoint);
  if (!exchange.endpoint.empty() && !is_safe(exchange.endpoint))
    table.refuse(
        "endpoint",
        "\"ipc\" or a loopback address such as \"tcp://127.0.0.1:*\"; from any other address a stranger "
        "could take part, since participants prove no keys");
  table.refuse_unknown_keys();
  return exchange;
}

Participants read_participants(TableReader& document) {
  TableReader table = document.optional_table("participants");
  Participants participants;
  table.choice("network", network_solvers, NetworkSolver::fissura);
  table.refuse_unknown_keys();
  return participants;
}

}  // namespace fissura::input
