// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "common/coupling/interface_compliance.hpp"
#include "tests/common/trace_network.hpp"

using namespace fissura;

namespace {

void time_compliance(const FractureNetwork& network, const char* name) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<double> compliance = interface_compliance(network, 35e9, 1);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  fmt::print("{:<7} {:>5} nodes {:>8.1f} ms\n", name, compliance.size(), spent.count());
}

/// One fracture with branches of 6 m every 4 m.
FractureNetwork tree(int branches) {
  test::TraceNetwork trace;
  std::vector<std::array<double, 2>> trunk;
  for (int i = 0; i <= branches + 1; ++i) trunk.push_back({4.0 * i, 0});
  trace.add_line(trunk, 0.5);
  for (int i = 1; i <= branches; ++i) trace.add_line({{4.0 * i, -3}, {4.0 * i, 0}, {4.0 * i, 3}}, 0.5);
  return trace.network();
}

/// `count` fractures each way, 4 m apart.
FractureNetwork blocks(int count) {
  test::TraceNetwork trace;
  for (int k = 0; k < count; ++k) {
    std::vector<std::array<double, 2>> across, along;
    for (int i = -1; i <= count; ++i) {
      across.push_back({4.0 * i, 4.0 * k});
      along.push_back({4.0 * k, 4.0 * i});
    }
    trace.add_line(across, 0.5);
    trace.add_line(along, 0.5);
  }
  return trace.network();
}

}  // namespace

int main() {
  for (const int branches : {3, 8, 14, 50, 100}) time_compliance(tree(branches), "tree");
  for (const int count : {4, 8, 12, 18}) time_compliance(blocks(count), "blocks");
}
