// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/interval_figures.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "tests/coupler/scheme/chain.hpp"

using namespace fissura;
using namespace fissura::coupler;
using fissura::coupler::test::chain_network;

namespace {

/// 12 MPa of compression along x, 5 MPa along y, 2 MPa of shear; 3 MPa of pore pressure.
Case stressed_case() {
  Case value;
  value.rock.biot_coefficient = 0.8;
  value.in_situ.stress = {-12e6, -5e6, 2e6, -10e6};
  value.in_situ.pore_pressure = 3e6;
  value.injection.perforations = {{"perforation", {0, 0}, 1e-5}};
  return value;
}

/// Five nodes, the last closed and partly filled.
StructureResponse some_structure() {
  StructureResponse structure;
  structure.aperture = {1e-3, 2e-3, 3e-3, 2e-3, 0};
  structure.closed = {0, 0, 0, 0, 1};
  structure.broken = {0, 1, 1, 1, 0};
  return structure;
}

NetworkAnswer some_answer() {
  NetworkAnswer answer;
  answer.pressure = {6e6, 6e6, 7e6, 6e6, 0};
  answer.aperture_predicted = {1.1e-3, 2e-3, 2.8e-3, 2e-3, 5e-3};
  answer.filled = {1, 1, 1, 1, 0.5};
  return answer;
}

}  // namespace

TEST_CASE("closure is the total stress normal to the fracture, at any inclination", "[coupler][scheme]") {
  const Case value = stressed_case();
  // Total = effective + Biot times pore pressure, compression positive; the shear counts twice sin cos of the
  // normal.
  CHECK(find_inlet(chain_network(5, 1, 0), value)->closure == Approx(5e6 + 2.4e6).epsilon(1e-12));
  CHECK(find_inlet(chain_network(5, 1, std::numbers::pi / 2), value)->closure ==
        Approx(12e6 + 2.4e6).epsilon(1e-12));
  CHECK(find_inlet(chain_network(5, 1, std::numbers::pi / 4), value)->closure ==
        Approx((12e6 + 5e6) / 2 + 2e6 + 2.4e6).epsilon(1e-12));
  CHECK(find_inlet(chain_network(5, 1, -std::numbers::pi / 4), value)->closure ==
        Approx((12e6 + 5e6) / 2 - 2e6 + 2.4e6).epsilon(1e-12));
}

TEST_CASE("closure is taken where the perforation is", "[coupler][scheme]") {
  Case value = stressed_case();
  value.in_situ.stress_gradient[1] = {1e5, 0};
  value.in_situ.pore_pressure_gradient = {-2e5, 0};
  Insertion insertion = test::chain(5, 1, 0);
  insertion.new_perforations.front().node = 4;
  FractureNetwork network;
  network.apply(insertion);
  const Inlet inlet = find_inlet(network, value).value();
  CHECK(inlet.node == 4);
  CHECK(inlet.closure == Approx(5e6 - 2e5 + 0.8 * (3e6 - 4e5)).epsilon(1e-12));
}

TEST_CASE("the mismatch is the difference of volumes, the drift that of apertures, over filled nodes only",
          "[coupler][scheme]") {
  const FractureNetwork network = chain_network(5, 1, 0);
  // Differences -1e-4 and +2e-4 m against apertures that sum up to 8e-3 m.
  CHECK(drift(network, some_structure(), some_answer()) == Approx(3e-4 / 8e-3).epsilon(1e-12));
  const IntervalRecord record =
      interval_figures({3, 1, 2}, network, Inlet{2, 1e-5, 5e6}, some_structure(), some_answer());
  CHECK(record.mismatch == Approx(1e-4 / 8e-3).epsilon(1e-12));
  CHECK(record.drift == Approx(3e-4 / 8e-3).epsilon(1e-12));
}

TEST_CASE("without a filled node there is neither mismatch nor drift", "[coupler][scheme]") {
  NetworkAnswer dry = some_answer();
  dry.filled.assign(5, 0.9);
  const IntervalRecord record =
      interval_figures({3, 1, 2}, chain_network(5, 1, 0), Inlet{2, 1e-5, 5e6}, some_structure(), dry);
  CHECK(record.mismatch == 0);
  CHECK(record.drift == 0);
}

TEST_CASE("the half length is the middle of what is open and what is fully broken", "[coupler][scheme]") {
  const FractureNetwork network = chain_network(5, 1, 0);
  const Inlet inlet{2, 1e-5, 5e6};
  const IntervalRecord record = interval_figures({3, 1, 2}, network, inlet, some_structure(), some_answer());
  CHECK(record.half_length_open == 1.5);
  CHECK(record.half_length_broken == 1);
  CHECK(record.half_length == 1.25);
  StructureResponse shut = some_structure();
  shut.closed = {1, 0, 0, 1, 1};
  // What has closed again does not count although it is broken.
  CHECK(interval_figures({3, 1, 2}, network, inlet, shut, some_answer()).half_length == 0.5);
}

TEST_CASE("the inlet's figures are its opening without the stored aperture and its pressure beyond closure",
          "[coupler][scheme]") {
  NetworkAnswer answer = some_answer();
  answer.ledger.injected = 3;
  answer.ledger.in_place = 1;
  answer.ledger.in_fractures = 2;
  const IntervalRecord record =
      interval_figures({3, 1, 2.5}, chain_network(5, 1, 0), Inlet{2, 1e-5, 5e6}, some_structure(), answer);
  CHECK(record.inlet_aperture == Approx(3e-3 - 1e-5).epsilon(1e-12));
  CHECK(record.inlet_pressure == 7e6);
  CHECK(record.inlet_net_pressure == Approx(2e6).epsilon(1e-12));
  CHECK(record.efficiency == 0.5);
  CHECK(record.time == 2.5);
  CHECK(record.duration == 1.5);
}

TEST_CASE("the junction pressure is the greatest over junctions, and zero without any", "[coupler][scheme]") {
  const Inlet inlet{2, 1e-5, 5e6};
  CHECK(interval_figures({3, 1, 2}, chain_network(5, 1, 0), inlet, some_structure(), some_answer())
            .junction_pressure == 0);
  Insertion insertion = test::chain(5, 1, 0);
  insertion.new_nodes[1].role = insertion.new_nodes[3].role = NodeRole::junction;
  FractureNetwork network;
  network.apply(insertion);
  NetworkAnswer answer = some_answer();
  answer.pressure = {9e6, 5e6, 8e6, 6e6, 0};
  CHECK(interval_figures({3, 1, 2}, network, inlet, some_structure(), answer).junction_pressure == 6e6);
}

TEST_CASE("fluid that was found in natural fractures counts as supplied in the efficiency",
          "[coupler][scheme]") {
  NetworkAnswer answer = some_answer();
  answer.ledger.injected = 3;
  answer.ledger.found = 1;
  answer.ledger.in_fractures = 2;
  CHECK(interval_figures({3, 1, 2}, chain_network(5, 1, 0), Inlet{2, 1e-5, 5e6}, some_structure(), answer)
            .efficiency == 0.5);
}
