// SPDX-License-Identifier: GPL-3.0-or-later
// One pressure for the whole network, p = 0 until it is full: volume V = in place + injected, sum l e(p) (1 + p / K_f) = V by bisection.
#include <algorithm>
#include <common/errors.hpp>
#include <common/flow_solver/flow_solver.hpp>
#include <common/flow_solver/pumping_schedule.hpp>
#include <cstring>

namespace {

class OnePressure : public fissura::FlowSolver {
 public:
  std::set<std::string> physics() const override { return {}; }

  void join(const fissura::FlowCase& flow_case) override {
    case_ = flow_case;
    schedule_ = fissura::Schedule(flow_case.stages);
    if (!case_.dry) bulk_modulus_ = case_.fluids.front().bulk_modulus;
  }

  void insert(const fissura::Insertion&, const fissura::FractureNetwork& network) override { network_ = &network; }

  fissura::FlowAnswer advance(const fissura::CouplingInterval& interval) override {
    now_ = interval;
    if (state_.started == 0 && !case_.dry) {
      for (std::size_t i = 0; i < interval.aperture.size(); ++i) state_.in_place += length(i) * interval.aperture[i];
      state_.volume = state_.in_place;
    }
    state_.started = 1;
    state_.rate = 0;
    for (double begin = interval.begin, end; begin < interval.end; begin = end) {
      end = std::min(interval.end, schedule_.next_change(begin).value_or(interval.end));
      const auto stage = schedule_.stage_from(begin);
      if (!stage || case_.dry) continue;
      const fissura::PumpingStage& in_force = schedule_.stages()[*stage];
      if (in_force.begin != state_.stage_begin) state_.entry_rate = state_.last_rate, state_.stage_begin = in_force.begin;
      const double pumped = (end - begin) * fissura::mean_target(in_force, {.rate = state_.entry_rate}, begin, end);
      state_.injected += pumped;
      state_.volume += pumped;
      state_.rate = state_.last_rate = fissura::target_at(in_force, {.rate = state_.entry_rate}, end);
    }
    find_pressure();
    return answer();
  }

  fissura::StateKept state_kept() const override { return fissura::StateKept::own; }

  std::vector<std::byte> save() const override {
    std::vector<std::byte> bytes(sizeof(State));
    std::memcpy(bytes.data(), &state_, sizeof(State));
    return bytes;
  }

  void restore(std::span<const std::byte> bytes, const fissura::FractureNetwork& network) override {
    if (bytes.size() != sizeof(State)) throw fissura::Error(fissura::ExitCode::checkpoint_unusable, "a state of another length");
    std::memcpy(&state_, bytes.data(), sizeof(State));
    network_ = &network;
  }

 private:
  struct State {
    double volume = 0, in_place = 0, injected = 0;                    // per thickness [m2]
    double pressure = 0, filled = 0, rate = 0, last_rate = 0, entry_rate = 0, stage_begin = -1, started = 0;
  };

  double length(std::size_t node) const { return network_->nodes()[node].lumped_length; }

  double aperture(std::size_t node, double pressure) const {
    const double above = pressure - now_.reference_pressure[node];
    const double opened = now_.aperture[node] + now_.aperture_rate[node] * (now_.end - now_.begin);
    return std::max(0.0, opened + now_.compliance[node] * (now_.closed[node] ? std::max(0.0, above) : above));
  }

  double room(double pressure) const {
    double sum = 0;
    for (std::size_t i = 0; i < now_.aperture.size(); ++i) sum += length(i) * aperture(i, pressure) * (1 + pressure / bulk_modulus_);
    return sum;
  }

  void find_pressure() {
    double low = 0, high = 1e12;
    const double empty = room(0);
    for (int k = 0; k < 200; ++k) (room(low + (high - low) / 2) < state_.volume ? low : high) = low + (high - low) / 2;
    state_.pressure = case_.dry || empty >= state_.volume ? 0 : high;
    state_.filled = state_.pressure > 0 ? 1 : empty > 0 ? std::min(state_.volume / empty, 1 - 1e-15) : 0;
  }

  fissura::FlowAnswer answer() const {
    const std::size_t nodes = now_.aperture.size();
    fissura::FlowAnswer result;
    result.pressure.assign(nodes, state_.pressure);
    result.filled.assign(nodes, state_.filled);
    for (std::size_t i = 0; i < nodes; ++i) result.aperture_predicted.push_back(aperture(i, state_.pressure));
    const double h = case_.thickness;
    result.ledger = {.injected = h * state_.injected, .in_place = h * state_.in_place, .in_fractures = h * state_.volume};
    result.well_pressure = state_.pressure;
    result.rate = h * state_.rate;
    return result;
  }

  fissura::FlowCase case_;
  fissura::Schedule schedule_;
  fissura::CouplingInterval now_;
  const fissura::FractureNetwork* network_ = nullptr;
  double bulk_modulus_ = 1;
  State state_;
};

}  // namespace

int main(int argc, char** argv) {
  OnePressure solver;
  return fissura::flow_solver_main(argc, argv, "one pressure", "1", solver);
}
