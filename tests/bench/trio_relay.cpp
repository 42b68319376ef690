// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/trio_relay.hpp"

#include <fmt/format.h>

#include "coupler/scheme/coupling_law.hpp"

namespace fissura::bench {

namespace {

constexpr double pressure = 6e6, aperture = 1e-3, interval_length = 1e-3, bulk_modulus = 2e9;
constexpr PressureRange pressure_range{0, 1e9};

Insertion nodes_alone(std::size_t count) {
  Insertion insertion;
  insertion.new_nodes.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    insertion.new_nodes.push_back({.id = i, .x = static_cast<double>(i), .lumped_length = 1});
  return insertion;
}

/// Nothing but the exchange.
class InstantSolver : public Solver {
 public:
  void join(const Assignment&) override {}
  Insertion first_topology() override {
    network_.apply(nodes_alone(1));
    return nodes_alone(1);
  }
  std::string insert(const Insertion& insertion) override {
    network_.apply(insertion);
    return network_.topology_hash();
  }
  Message report(const Message&) override { return Message(MessageType::fields); }
  std::vector<std::byte> save() override { return {}; }
  std::optional<std::string> restore(const std::vector<std::byte>&) override { return {}; }

 private:
  FractureNetwork network_;
};

class InstantNetwork : public InstantSolver {
 public:
  Message advance(const Message& command) override {
    const std::vector<double> apertures = command.numbers("aperture");
    const std::size_t count = apertures.size();
    (void)command.numbers("aperture_rate", count);
    const std::vector<double> reference = command.numbers("reference_pressure", count);
    (void)command.numbers("compliance", count);
    (void)command.numbers("closed", count);
    filled_.resize(count, 1.0);
    Message answer(MessageType::pressure);
    answer.body = {
        {"ledger",
         {{"injected", 1.0}, {"in_place", 0.0}, {"in_fractures", 1.0}, {"leaked", 0.0}, {"reset", 0.0}}},
        {"well_pressure", pressure},
        {"rate", 1e-3},
        {"newton", {{"converged", true}, {"iterations", 0}, {"residual", 0.0}, {"halvings", 0}}}};
    answer.add("pressure", "Pa", reference);
    answer.add("aperture_predicted", "m", apertures);
    answer.add("filled", "1", filled_);
    return answer;
  }

 private:
  std::vector<double> filled_;
};

class InstantStructure : public InstantSolver {
 public:
  Message advance(const Message& command) override {
    const std::vector<double> pressure_begin = command.numbers("pressure_begin");
    const std::size_t count = pressure_begin.size();
    const std::vector<double> pressure_end = command.numbers("pressure_end", count);
    (void)command.numbers("aperture_begin", count);
    const std::vector<double> apertures = command.numbers("aperture_end", count);
    (void)command.numbers("stiffness", count);
    zero_.resize(count, 0.0);
    Message answer(MessageType::response);
    answer.body = {{"stable_step", 1e-4}, {"mass_scale", 1.0}, {"steps", 0}, {"energy", {{"kinetic", 0.0}}}};
    answer.add("aperture", "m", apertures);
    answer.add("aperture_rate", "m/s", zero_);
    answer.add("pressure_applied", "Pa", pressure_end);
    answer.add("pressure_opening", "Pa", pressure_begin);
    answer.add("closed", "1", zero_);
    answer.add("broken", "1", zero_);
    return answer;
  }

 private:
  std::vector<double> zero_;
};

coupler::TrioOptions options(const std::string& endpoint, const std::string& program) {
  coupler::TrioOptions options;
  options.listening.endpoint = endpoint;
  for (const Role role : {Role::structure, Role::network})
    options.command[static_cast<std::size_t>(role)] = fmt::format("'{}' {} --log error", program, name(role));
  // While the other relays are measured the participants hear nothing.
  options.deadlines.progress = 3600;
  return options;
}

}  // namespace

TrioRelay::TrioRelay(const std::string& endpoint, const std::string& program)
    : trio_(options(endpoint, program), RunId{1}, 0, status_) {
  trio_.start(nlohmann::json::object(), coupler::Start::fresh);
  const Message topology = trio_.await(Role::structure, MessageType::topology);
  for (const Role role : {Role::structure, Role::network}) {
    Message insert(MessageType::insert);
    insert.body["insertion"] = topology.value<nlohmann::json>("insertion");
    (void)trio_.request(role, std::move(insert), MessageType::acknowledge);
  }
}

TrioRelay::~TrioRelay() {
  trio_.finish();
}

void TrioRelay::set_values(std::size_t count) {
  network_ = FractureNetwork();
  network_.apply(nodes_alone(count));
  compliance_.assign(count, 1e-9);
  structure_.aperture.assign(count, aperture);
  structure_.pressure_applied.assign(count, pressure);
  structure_.pressure_opening.assign(count, pressure);
  structure_.aperture_rate.assign(count, 0);
  structure_.closed.assign(count, 0);
  structure_.broken.assign(count, 0);
}

void TrioRelay::step() {
  const double begin = interval_length * static_cast<double>(interval_++);
  const ClockInterval interval{interval_, begin, begin + interval_length};
  const Message pressures =
      trio_.request(Role::network,
                    coupler::advance_network(interval, network_.revision(),
                                             coupler::robin_estimate(structure_, compliance_)),
                    MessageType::pressure);
  const coupler::NetworkAnswer answer = coupler::read_pressure(pressures, network_, pressure_range);
  const Message response = trio_.request(
      Role::structure,
      coupler::advance_structure(interval, network_.revision(),
                                 coupler::robin_ramps(structure_, answer, compliance_, bulk_modulus),
                                 coupler::StrainEnergy::not_wanted),
      MessageType::response);
  structure_ = coupler::read_response(response, network_, pressure_range);
}

int play(Role role, int argc, char** argv) {
  InstantNetwork network;
  InstantStructure structure;
  Solver& solver = role == Role::network ? static_cast<Solver&>(network) : structure;
  return participant_main(role, argc, argv, "bench", FISSURA_VERSION, solver);
}

}  // namespace fissura::bench
