// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/coupling/line_compliance.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "common/coupling/interface_compliance.hpp"
#include "common/coupling/trace_lines.hpp"
#include "tests/common/trace_network.hpp"

using namespace fissura;
using namespace fissura::test;

namespace {

constexpr double modulus = 35e9, spacing = 0.5, pi = 3.14159265358979323846;

/// A fracture of `length` along x whose end, at the origin, lies in the middle of another one of
/// `crossed_length`.
FractureNetwork tee(double length, double crossed_length, double angle) {
  TraceNetwork trace;
  const double x = crossed_length / 2 * std::cos(angle), y = crossed_length / 2 * std::sin(angle);
  trace.add_line({{-length, 0}, {0, 0}}, spacing);
  trace.add_line({{-x, -y}, {0, 0}, {x, y}}, spacing);
  return trace.network();
}

/// `count` lines each way, 4 m apart, that enclose blocks.
FractureNetwork blocks(int count) {
  TraceNetwork trace;
  for (int k = 0; k < count; ++k) {
    std::vector<std::array<double, 2>> across, along;
    for (int i = -1; i <= count; ++i) {
      across.push_back({4.0 * i, 4.0 * k});
      along.push_back({4.0 * k, 4.0 * i});
    }
    trace.add_line(across, spacing);
    trace.add_line(along, spacing);
  }
  return trace.network();
}

}  // namespace

TEST_CASE("lines go straight on through junctions and end where they would have to turn",
          "[common][coupling]") {
  const std::vector<TraceLine> lines = trace_lines(tee(10, 6, pi / 2));
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].length == Approx(10).epsilon(1e-12));
  CHECK(lines[1].length == Approx(6).epsilon(1e-12));
  CHECK(trace_lines(blocks(3)).size() == 6);
  TraceNetwork bent;
  bent.add_line({{0, 0}, {5, 0}, {0, 1}}, spacing);
  CHECK(trace_lines(bent.network()).size() == 1);
}

TEST_CASE("a ring is one line, whichever segment is the first", "[common][coupling]") {
  TraceNetwork trace;
  trace.add_line({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, spacing);
  const FractureNetwork network = trace.network();
  const std::vector<TraceLine> lines = trace_lines(network);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].ring());
  CHECK(lines[0].segments.size() == network.segments().size());
  for (const double value : line_compliance(network, modulus))
    CHECK(value == Approx(4 * 8 / modulus).epsilon(1e-12));
}

TEST_CASE("a straight fracture opens by lines as by its closed form", "[common][coupling]") {
  TraceNetwork trace;
  trace.add_line({{0, 0}, {12, 3}}, spacing);
  const FractureNetwork network = trace.network();
  const std::vector<double> by_lines = line_compliance(network, modulus);
  const std::vector<double> closed_form = interface_compliance(network, modulus, 1);
  // Both measure from the middle of the end cell; the cells differ by the rounding of the spacing to the
  // length.
  for (std::size_t i = 0; i < by_lines.size(); ++i)
    CHECK(by_lines[i] == Approx(closed_form[i]).epsilon(0.05));
}

TEST_CASE("a fracture that ends at a right angle opens by lines within a half of the row sum",
          "[common][coupling]") {
  const double length = GENERATE(10.0, 20.0, 40.0), crossed = GENERATE(6.0, 12.0);
  CAPTURE(length, crossed);
  const FractureNetwork network = tee(length, crossed, pi / 2);
  const std::vector<double> row_sum = interface_compliance(network, modulus, 1);
  const std::vector<double> by_lines = line_compliance(network, modulus);
  for (std::size_t i = 0; i < by_lines.size(); ++i) {
    CHECK(by_lines[i] < 1.5 * row_sum[i]);
    CHECK(by_lines[i] > row_sum[i] / 1.5);
  }
}

TEST_CASE("no arm is softer than the longest fracture alone, however many blocks are enclosed",
          "[common][coupling]") {
  const FractureNetwork network = blocks(4);
  const std::vector<double> compliance = interface_compliance(network, modulus, 1);
  const double longest = 4 * 5 + spacing;
  for (std::size_t i = 0; i < compliance.size(); ++i) {
    CHECK(compliance[i] <= 2 * longest / modulus * (1 + 1e-12));
    CHECK(compliance[i] >= compliance_floor(network.nodes()[i].lumped_length, modulus));
  }
  CHECK(*std::max_element(compliance.begin(), compliance.end()) > 1.9 * longest / modulus);
}

TEST_CASE("a network of lines keeps its whole opening where a single fracture takes a share",
          "[common][coupling]") {
  const FractureNetwork network = blocks(4);
  CHECK(interface_compliance(network, modulus, 0.3) == interface_compliance(network, modulus, 1));
  CHECK(interface_compliance(network, modulus, 2)[0] ==
        Approx(2 * interface_compliance(network, modulus, 1)[0]));
  const FractureNetwork tree = tee(20, 6, pi / 2);
  CHECK(interface_compliance(tree, modulus, 0.3)[20] ==
        Approx(0.3 * interface_compliance(tree, modulus, 1)[20]));
}
