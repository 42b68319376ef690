// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "common/case/case_json.hpp"
#include "common/errors.hpp"
#include "tests/network/flow_setup.hpp"
#include "tests/network/messaged_network.hpp"

using namespace fissura;
using namespace fissura::network;

namespace {

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

Message advance_command(std::size_t nodes, double begin, double end) {
  Message command(MessageType::advance);
  command.body = {{"begin", begin}, {"end", end}, {"carry", "content"}};
  std::vector<double> aperture(nodes), zero(nodes, 0.0), compliance(nodes, 1e-10), reference(nodes, 5e6);
  for (std::size_t i = 0; i < nodes; ++i)
    aperture[i] = begin == 0 && i != 2 ? 0 : 1e-4 * (1 + begin) * static_cast<double>(1 + (i * 7) % 5);
  command.add("aperture", "m", aperture);
  command.add("aperture_rate", "m/s", zero);
  command.add("reference_pressure", "Pa", reference);
  command.add("compliance", "m/Pa", compliance);
  command.add("closed", "1", zero);
  return command;
}

Insertion growth(std::uint64_t revision, std::uint64_t id, double time) {
  Insertion insertion;
  insertion.revision = revision;
  insertion.new_nodes.push_back({.id = id,
                                 .x = 0.1 * static_cast<double>(id),
                                 .lumped_length = 0.3,
                                 .role = NodeRole::tip,
                                 .exposure_time = time});
  insertion.new_segments.push_back({.id = id, .node_a = id - 1, .node_b = id, .length = 0.5});
  insertion.parents.push_back({id, id - 1});
  return insertion;
}

/// Also with apertures per arm.
Message natural_command(std::size_t nodes, std::size_t segments, double begin, double end) {
  Message command = advance_command(nodes, begin, end);
  std::vector<double> a(segments), b(segments);
  for (std::size_t s = 0; s < segments; ++s) a[s] = 2 * (b[s] = 1e-4 * static_cast<double>(s % 3 + 1));
  command.add("arm_aperture_a", "m", a);
  command.add("arm_aperture_b", "m", b);
  return command;
}

/// A saturated natural fracture of seven nodes, joined at its first to the last of `nodes`.
Insertion natural_growth(std::uint64_t nodes, double time) {
  Insertion insertion;
  insertion.revision = 1;
  for (std::uint64_t id = nodes + 1; id <= nodes + 7; ++id) {
    insertion.new_nodes.push_back({.id = id,
                                   .x = 5,
                                   .y = 0.1 * static_cast<double>(id),
                                   .lumped_length = 0.5,
                                   .exposure_time = time,
                                   .saturated = true,
                                   .formation_pressure = 3e6,
                                   .joint_compliance = 1e-11});
    insertion.new_segments.push_back({.id = id,
                                      .node_a = id - 1,
                                      .node_b = id,
                                      .kind = id == nodes + 1 ? SegmentKind::hydraulic : SegmentKind::natural,
                                      .length = 0.5});
  }
  insertion.parents.push_back({nodes + 1, nodes});
  return insertion;
}

void join(test::MessagedNetwork& solver) {
  solver.join({case_to_json(water_case()), 1});
  (void)solver.insert(test::straight_fracture(5, 0.5, {2}));
}

void require_same_bits(const Message& a, const Message& b) {
  CHECK(a.body == b.body);
  REQUIRE(a.arrays.size() == b.arrays.size());
  for (std::size_t k = 0; k < a.arrays.size(); ++k) {
    CAPTURE(a.arrays[k].name);
    CHECK(a.arrays[k].bytes == b.arrays[k].bytes);
  }
}

}  // namespace

TEST_CASE("network solver: the ledger is in cubic metres of the whole thickness", "[network][solver]") {
  test::MessagedNetwork solver;
  join(solver);
  const Message answer = solver.advance(advance_command(5, 0, 0.1));
  CHECK(answer.type == MessageType::pressure);
  const nlohmann::json& ledger = answer.body["ledger"];
  CHECK(ledger["injected"].get<double>() == Approx(2e-3 * 0.1).epsilon(1e-14));
  // Node 2 alone has an aperture at the start: 5e-4 m over 0.5 m and 2 m of thickness.
  CHECK(ledger["in_place"].get<double>() == Approx(1e-4 * (1 + 14 % 5) * 0.5 * 2).epsilon(1e-14));
  CHECK(std::abs(ledger["residual"].get<double>()) <= 1e-18);
  CHECK(answer.body["rate"].get<double>() == Approx(2e-3).epsilon(1e-15));
  CHECK(answer.body["newton"]["converged"] == true);
  CHECK(answer.numbers("pressure", 5).size() == 5);
  CHECK(answer.numbers("aperture_predicted", 5)[2] > 0);
  CHECK(answer.numbers("filled", 5)[2] == 1);
}

TEST_CASE("network solver: a restored state goes on bit for bit", "[network][solver]") {
  test::MessagedNetwork straight, resumed;
  join(straight);
  std::size_t nodes = 5;
  double time = 0;
  const auto next = [&](test::MessagedNetwork& solver) {
    return solver.advance(advance_command(nodes, time, time + 0.01));
  };
  for (int k = 0; k < 25; ++k) {
    (void)next(straight);
    time = time + 0.01;
    if (k % 10 == 4) {
      const std::string hash = straight.insert(growth(nodes - 4, nodes + 1, time));
      CHECK_FALSE(hash.empty());
      ++nodes;
    }
  }
  resumed.join({case_to_json(water_case()), 1});
  resumed.restore(straight.save());
  CHECK(resumed.save() == straight.save());
  for (int k = 0; k < 25; ++k) {
    require_same_bits(next(straight), next(resumed));
    time = time + 0.01;
    if (k % 10 == 4) {
      const Insertion insertion = growth(nodes - 4, nodes + 1, time);
      CHECK(straight.insert(insertion) == resumed.insert(insertion));
      ++nodes;
    }
  }
  require_same_bits(straight.report(Message(MessageType::report)),
                    resumed.report(Message(MessageType::report)));
  CHECK(resumed.save() == straight.save());
}

TEST_CASE("network solver: a damaged or foreign checkpoint is refused", "[network][solver]") {
  test::MessagedNetwork solver;
  join(solver);
  std::vector<std::byte> bytes = solver.save();
  bytes.resize(bytes.size() / 2);
  try {
    solver.restore(bytes);
    FAIL("half a checkpoint was accepted");
  } catch (const Error& refusal) {
    CHECK(refusal.code() == ExitCode::checkpoint_unusable);
  }
  Case other_case = water_case();
  other_case.leak_off.coefficient *= 2;
  test::MessagedNetwork other;
  other.join({case_to_json(other_case), 1});
  CHECK_THROWS_WITH(other.restore(solver.save()), Catch::Contains("another case"));
  other_case = water_case();
  other_case.time.end *= 2;
  other.join({case_to_json(other_case), 1});
  CHECK_NOTHROW(other.restore(solver.save()));
}

TEST_CASE("network solver: fields give fluxes per segment and fractions per fluid", "[network][solver]") {
  test::MessagedNetwork solver;
  join(solver);
  (void)solver.advance(advance_command(5, 0, 0.1));
  (void)solver.advance(advance_command(5, 0.1, 0.2));
  const Message fields = solver.report(Message(MessageType::report));
  CHECK(fields.numbers("flux", 4)[0] < 0);
  CHECK(fields.numbers("flux", 4)[3] > 0);
  const std::vector<double> fraction = fields.numbers("fluid_fraction", 10);
  CHECK(fraction[2 * 2 + 1] > 0);
  CHECK(fraction[2 * 2] + fraction[2 * 2 + 1] == Approx(1).epsilon(1e-14));
  CHECK(fields.numbers("leaked", 5)[2] > 0);
}

TEST_CASE("network solver: arrays that do not fit, gaps in time and negative apertures are refused",
          "[network][solver]") {
  test::MessagedNetwork solver;
  join(solver);
  CHECK_THROWS_AS(solver.advance(advance_command(4, 0, 0.1)), ProtocolError);
  CHECK_THROWS_AS(solver.advance(advance_command(5, 0.1, 0.1)), ProtocolError);
  (void)solver.advance(advance_command(5, 0, 0.1));
  CHECK_THROWS_AS(solver.advance(advance_command(5, 0.2, 0.3)), ProtocolError);
  Message negative = advance_command(5, 0.1, 0.2);
  negative.arrays.erase(negative.arrays.begin());
  negative.add("aperture", "m", std::vector<double>{0, 0, -1e-6, 0, 0});
  CHECK_THROWS_AS(solver.advance(negative), ValueError);
}

TEST_CASE("network solver: a case without fluid or with an unknown one is refused", "[network][solver]") {
  test::MessagedNetwork solver;
  Case value = water_case();
  value.injection.stages.back().fluid = "honey";
  CHECK_THROWS_WITH(solver.join({case_to_json(value), 1}), Catch::Contains("honey"));
  value.fluids.clear();
  CHECK_THROWS_AS(solver.join({case_to_json(value), 1}), InputError);
}

TEST_CASE("network solver: figures count the work", "[network][solver]") {
  test::MessagedNetwork solver;
  join(solver);
  (void)solver.advance(advance_command(5, 0, 0.1));
  const nlohmann::json figures = solver.finish();
  CHECK(figures["intervals"] == 1);
  CHECK(figures["newton_iterations"].get<long>() > 0);
  CHECK(figures["factorisations"] == figures["newton_iterations"]);
}

TEST_CASE("network solver: a dry case has no pressure and holds nothing, with and without open slits",
          "[network][solver]") {
  Case dry = water_case();
  dry.injection = {};
  dry.fluids.clear();
  test::MessagedNetwork solver;
  solver.join({case_to_json(dry), 1});
  Insertion slit = test::straight_fracture(5, 0.5, {2});
  slit.new_perforations.clear();
  const bool with_slit = GENERATE(true, false);
  (void)solver.insert(with_slit ? slit : Insertion{});
  const std::size_t nodes = with_slit ? 5 : 0;
  const std::vector<double> zero(nodes, 0.0);
  const Message command = advance_command(nodes, 0, 0.1);
  const Message answer = solver.advance(command);
  CHECK(answer.numbers("pressure", nodes) == zero);
  CHECK(answer.numbers("filled", nodes) == zero);
  CHECK(answer.numbers("aperture_predicted", nodes) == command.numbers("aperture", nodes));
  for (const char* volume : {"injected", "in_place", "found", "in_fractures", "leaked", "reset", "residual"})
    CHECK(answer.body["ledger"][volume] == 0);
  CHECK(answer.body["newton"]["converged"] == true);
  if (with_slit) (void)solver.insert(growth(1, 6, 0.1));
  CHECK_NOTHROW(solver.advance(advance_command(nodes + (with_slit ? 1 : 0), 0.1, 0.2)));
  CHECK_NOTHROW(solver.report(Message(MessageType::report)));
  test::MessagedNetwork resumed;
  resumed.join({case_to_json(dry), 1});
  resumed.restore(solver.save());
  CHECK(resumed.finish()["intervals"] == 2);
}

TEST_CASE(
    "network solver: a state with natural fractures goes on bit for bit, from before they gave their fluid "
    "too",
    "[network][solver]") {
  const int saved_after = GENERATE(0, 3);
  test::MessagedNetwork straight, resumed;
  join(straight);
  (void)straight.advance(natural_command(5, 4, 0, 0.1));
  (void)straight.insert(natural_growth(5, 0.1));
  const auto next = [](test::MessagedNetwork& solver, int k) {
    return solver.advance(natural_command(12, 11, 0.1 + 0.05 * k, 0.1 + 0.05 * (k + 1)));
  };
  for (int k = 0; k < saved_after; ++k) (void)next(straight, k);
  resumed.join({case_to_json(water_case()), 1});
  resumed.restore(straight.save());
  for (int k = saved_after; k < 20; ++k) require_same_bits(next(straight, k), next(resumed, k));
  CHECK(straight.save() == resumed.save());
  const nlohmann::json ledger = next(straight, 20).body["ledger"];
  CHECK(ledger["found"].get<double>() > 0);
  CHECK(std::abs(ledger["residual"].get<double>()) < 1e-13 * ledger["injected"].get<double>());
}

TEST_CASE("network solver: apertures of the arms come in pairs, one per segment, none below zero",
          "[network][solver]") {
  test::MessagedNetwork solver;
  join(solver);
  Message single = advance_command(5, 0, 0.1);
  single.add("arm_aperture_a", "m", std::vector<double>(4, 1e-3));
  CHECK_THROWS_AS(solver.advance(single), ProtocolError);
  Message negative = single;
  negative.add("arm_aperture_b", "m", std::vector<double>{1e-3, -1e-9, 0, 0});
  CHECK_THROWS_WITH(solver.advance(negative), Catch::Contains("arm_aperture_b of segment 2"));
  CHECK_THROWS_AS(solver.advance(natural_command(5, 5, 0, 0.1)), ProtocolError);
  CHECK_NOTHROW(solver.advance(natural_command(5, 4, 0, 0.1)));
}
