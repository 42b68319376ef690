// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/scheme/exchange.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <limits>

#include "common/errors.hpp"
#include "coupler/scheme/coupling_law.hpp"
#include "tests/coupler/scheme/chain.hpp"

using namespace fissura;
using namespace fissura::coupler;
using fissura::coupler::test::chain_network;

namespace {

constexpr PressureRange range{0, 1e8};

using Arrays = std::vector<std::pair<const char*, std::vector<double>>>;

Message with(Message message, const Arrays& arrays) {
  for (const auto& [name, values] : arrays) message.add(name, "1", values);
  return message;
}

Arrays response_arrays() {
  return {{"aperture", {1e-3, 2e-3, 0}},
          {"aperture_rate", {-1e-4, 0, 0}},
          {"pressure_applied", {6e6, 7e6, 0}},
          {"pressure_opening", {-1e6, -2e6, 0}},
          {"closed", {0, 0, 1}},
          {"broken", {0, 1, 0}}};
}

Message response_of(const Arrays& arrays) {
  Message message(MessageType::response);
  message.body = {
      {"stable_step", 1e-3}, {"mass_scale", 100.0}, {"steps", 12}, {"energy", {{"kinetic", 3.0}}}};
  return with(std::move(message), arrays);
}

Arrays pressure_arrays() {
  return {{"pressure", {6e6, 7e6, 0}}, {"aperture_predicted", {1e-3, 2e-3, 0}}, {"filled", {1, 1, 0.25}}};
}

Message pressure_of(const Arrays& arrays) {
  Message message(MessageType::pressure);
  message.body = {
      {"ledger",
       {{"injected", 5.0}, {"in_place", 1.0}, {"in_fractures", 4.0}, {"leaked", 2.5}, {"reset", 0.5}}},
      {"well_pressure", 8e6},
      {"rate", 1e-3},
      {"newton", {{"converged", true}, {"iterations", 4}, {"halvings", 0}}}};
  return with(std::move(message), arrays);
}

Arrays spoilt(Arrays arrays, const std::string& field, std::size_t node, double value) {
  for (auto& [name, values] : arrays)
    if (name == field) values[node] = value;
  return arrays;
}

struct Forbidden {
  const char* field;
  std::size_t node;
  double value;
  const char* shown;
};

}  // namespace

TEST_CASE("a sound RESPONSE is read as it was sent", "[coupler][scheme]") {
  const StructureResponse response =
      read_response(response_of(response_arrays()), chain_network(3, 1, 0), range);
  CHECK(response.aperture == std::vector<double>{1e-3, 2e-3, 0});
  CHECK(response.aperture_rate[0] == -1e-4);
  CHECK(response.pressure_opening[1] == -2e6);
  CHECK(response.broken[1] == 1);
  CHECK(response.stable_step == 1e-3);
  CHECK(response.mass_scale == 100);
  CHECK(response.steps == 12);
  CHECK(response.kinetic_energy == 3);
  CHECK_FALSE(response.strain_energy.has_value());
  CHECK_FALSE(response.proposal.has_value());
}

TEST_CASE("a structure may tell of natural fractures and probes, and need not", "[coupler][scheme]") {
  const FractureNetwork network = chain_network(3, 1, 0);
  Message message = response_of(response_arrays());
  const StructureResponse silent = read_response(message, network, range);
  CHECK(silent.natural_fractures.greatest_slip == 0);
  CHECK(silent.probes.empty());
  message.body["natural_fractures"] = {{"greatest_slip", 2e-4}, {"slipped_length", 6.0},
                                       {"opened_length", 1.5},  {"wetted_length", 7.0},
                                       {"slip_distance", 2.5},  {"greatest_far_slip", 3e-6}};
  message.body["probes"] = {{{"stress_xx", -15e6},
                             {"stress_yy", -10e6},
                             {"stress_xy", 1e5},
                             {"displacement_x", 1e-3},
                             {"displacement_y", -2e-3},
                             {"slip", nullptr},
                             {"opening", nullptr},
                             {"normal_traction", nullptr},
                             {"shear_traction", nullptr}}};
  const StructureResponse told = read_response(message, network, range);
  CHECK(told.natural_fractures.greatest_slip == 2e-4);
  CHECK(told.natural_fractures.slipped_length == 6);
  CHECK(told.natural_fractures.opened_length == 1.5);
  CHECK(told.natural_fractures.wetted_length == 7);
  CHECK(told.natural_fractures.slip_distance == 2.5);
  CHECK(told.natural_fractures.greatest_far_slip == 3e-6);
  REQUIRE(told.probes.size() == 1);
  CHECK(told.probes[0].stress_yy == -10e6);
  CHECK_FALSE(told.probes[0].slip.has_value());
  message.body["natural_fractures"].erase("slip_distance");
  CHECK_THROWS_WITH(read_response(message, network, range), Catch::Contains("slip_distance"));
}

TEST_CASE("an insertion need not meet anything", "[coupler][scheme]") {
  Message acknowledgement(MessageType::acknowledge);
  CHECK(read_meetings(acknowledgement).empty());
  acknowledgement.body["meetings"] = {{{"time", 2.5}}};
  CHECK_THROWS_AS(read_meetings(acknowledgement), ProtocolError);
}

TEST_CASE("a sound PRESSURE is read as it was sent, and its ledger balanced anew", "[coupler][scheme]") {
  const NetworkAnswer answer = read_pressure(pressure_of(pressure_arrays()), chain_network(3, 1, 0), range);
  CHECK(answer.pressure[1] == 7e6);
  CHECK(answer.filled[2] == 0.25);
  CHECK(answer.newton_iterations == 4);
  CHECK(answer.ledger.residual == 0);
  Message unbalanced = pressure_of(pressure_arrays());
  unbalanced.body["ledger"]["in_fractures"] = 4.5;
  const Ledger ledger = read_pressure(unbalanced, chain_network(3, 1, 0), range).ledger;
  CHECK(ledger.residual == -0.5);
  CHECK(ledger.relative_residual == Approx(0.5 / 5).epsilon(1e-14));
}

TEST_CASE("what physics forbids in a RESPONSE is refused with field, node, place and value",
          "[coupler][scheme]") {
  const auto bad =
      GENERATE(Forbidden{"aperture", 0, -1e-9, "-1e-09"}, Forbidden{"aperture", 1, 2e3, "2000"},
               Forbidden{"pressure_applied", 2, -1, "-1"}, Forbidden{"pressure_applied", 1, 1.1e8, "1.1e+08"},
               Forbidden{"closed", 2, 2, "2"}, Forbidden{"broken", 0, -1, "-1"});
  CAPTURE(bad.field, bad.value);
  const Message message = response_of(spoilt(response_arrays(), bad.field, bad.node, bad.value));
  const FractureNetwork network = chain_network(3, 1, 0);
  CHECK_THROWS_AS(read_response(message, network, range), ValueError);
  const std::string place = fmt::format("({}, ", static_cast<int>(bad.node) - 1);
  CHECK_THROWS_WITH(read_response(message, network, range),
                    Catch::StartsWith(std::string(bad.field) + " of node " + std::to_string(bad.node)) &&
                        Catch::Contains(place) &&
                        Catch::Contains(std::string(" m is ") + bad.shown + ", allowed is ["));
}

TEST_CASE("what physics forbids in a PRESSURE is refused with field, node and value", "[coupler][scheme]") {
  const auto bad = GENERATE(Forbidden{"pressure", 1, -1e-3, "-0.001"}, Forbidden{"pressure", 0, 2e8, "2e+08"},
                            Forbidden{"aperture_predicted", 2, -1e-6, "-1e-06"},
                            Forbidden{"filled", 0, 1.01, "1.01"}, Forbidden{"filled", 2, -0.1, "-0.1"});
  CAPTURE(bad.field, bad.value);
  const Message message = pressure_of(spoilt(pressure_arrays(), bad.field, bad.node, bad.value));
  const FractureNetwork network = chain_network(3, 1, 0);
  CHECK_THROWS_AS(read_pressure(message, network, range), ValueError);
  CHECK_THROWS_WITH(read_pressure(message, network, range),
                    Catch::StartsWith(std::string(bad.field) + " of node " + std::to_string(bad.node)) &&
                        Catch::Contains(std::string(" is ") + bad.shown));
}

TEST_CASE("a value that is not a number is refused whatever the field", "[coupler][scheme]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const char* field =
      GENERATE("aperture", "aperture_rate", "pressure_applied", "pressure_opening", "closed", "broken");
  CHECK_THROWS_WITH(
      read_response(response_of(spoilt(response_arrays(), field, 1, nan)), chain_network(3, 1, 0), range),
      Catch::Contains(std::string(field) + "[1] is nan"));
}

TEST_CASE("a structure without a stable step or with less than its own mass is refused",
          "[coupler][scheme]") {
  const FractureNetwork network = chain_network(3, 1, 0);
  Message message = response_of(response_arrays());
  message.body["stable_step"] = 0.0;
  CHECK_THROWS_AS(read_response(message, network, range), ValueError);
  message.body["stable_step"] = 1e-3;
  message.body["mass_scale"] = 0.5;
  CHECK_THROWS_AS(read_response(message, network, range), ValueError);
}

TEST_CASE("pressures that have not converged are refused", "[coupler][scheme]") {
  Message message = pressure_of(pressure_arrays());
  message.body["newton"]["converged"] = false;
  CHECK_THROWS_AS(read_pressure(message, chain_network(3, 1, 0), range), SolverError);
}

TEST_CASE("arrays of another topology, of another length or missing break the protocol",
          "[coupler][scheme]") {
  const FractureNetwork network = chain_network(3, 1, 0);
  Message other = pressure_of(pressure_arrays());
  other.revision = 1;
  CHECK_THROWS_WITH(read_pressure(other, network, range),
                    Catch::Contains("topology revision 1, the network has 0"));
  CHECK_THROWS_AS(read_pressure(pressure_of(pressure_arrays()), chain_network(4, 1, 0), range),
                  ProtocolError);
  CHECK_THROWS_AS(read_response(response_of({}), network, range), ProtocolError);
  Message silent = pressure_of(pressure_arrays());
  silent.body["ledger"].erase("leaked");
  CHECK_THROWS_WITH(read_pressure(silent, network, range), Catch::Contains("leaked"));
}

TEST_CASE("commands carry five arrays each way of the interface, one value per node", "[coupler][scheme]") {
  const StructureResponse structure =
      read_response(response_of(response_arrays()), chain_network(3, 1, 0), range);
  const NetworkAnswer answer = read_pressure(pressure_of(pressure_arrays()), chain_network(3, 1, 0), range);
  const std::vector<double> compliance(3, 1e-9);
  const ClockInterval interval{7, 1, 1.5};
  const Message to_network = advance_network(interval, 4, robin_estimate(structure, compliance));
  CHECK(to_network.interval == 7);
  CHECK(to_network.revision == 4);
  CHECK(to_network.arrays.size() == 5);
  CHECK(to_network.numbers("compliance", 3) == compliance);
  CHECK(to_network.value<std::string>("carry") == "content");
  const Message to_structure =
      advance_structure(interval, 4, robin_ramps(structure, answer, compliance, 2e9), StrainEnergy::wanted);
  CHECK(to_structure.arrays.size() == 5);
  CHECK(to_structure.numbers("pressure_begin", 3) == structure.pressure_applied);
  CHECK(to_structure.numbers("pressure_end", 3) == answer.pressure);
  CHECK(to_structure.numbers("aperture_begin", 3) == structure.aperture);
  CHECK(to_structure.numbers("aperture_end", 3) == answer.aperture_predicted);
  CHECK(to_structure.value<double>("end") == 1.5);
  CHECK(to_structure.value<bool>("strain_energy"));
}

TEST_CASE("apertures of the arms are read one per segment, and only both together", "[coupler][scheme]") {
  const FractureNetwork network = chain_network(3, 1, 0);
  Arrays arrays = response_arrays();
  CHECK(read_response(response_of(arrays), network, range).arm_aperture_a.empty());
  arrays.push_back({"arm_aperture_a", {1e-3, 5e-5}});
  CHECK_THROWS_AS(read_response(response_of(arrays), network, range), ProtocolError);
  arrays.push_back({"arm_aperture_b", {5e-5, 0}});
  const StructureResponse response = read_response(response_of(arrays), network, range);
  CHECK(response.arm_aperture_a == std::vector<double>{1e-3, 5e-5});
  CHECK(response.arm_aperture_b == std::vector<double>{5e-5, 0});
  CHECK_THROWS_WITH(read_response(response_of(spoilt(arrays, "arm_aperture_b", 1, -1e-6)), network, range),
                    Catch::StartsWith("arm_aperture_b of segment"));
  arrays.back().second.push_back(0);
  CHECK_THROWS_AS(read_response(response_of(arrays), network, range), ProtocolError);
}

TEST_CASE("fluid found in natural fractures balances the ledger", "[coupler][scheme]") {
  Message message = pressure_of(pressure_arrays());
  message.body["ledger"]["found"] = 2.0;
  message.body["ledger"]["in_fractures"] = 6.0;
  const Ledger ledger = read_pressure(message, chain_network(3, 1, 0), range).ledger;
  CHECK(ledger.found == 2);
  CHECK(ledger.residual == 0);
}
